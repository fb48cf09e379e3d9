using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("SphFluid.Playback.Tests.Editor")]
