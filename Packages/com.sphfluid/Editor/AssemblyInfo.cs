using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("SphFluid.Tests.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Playback.Editor")]
