using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("SphFluid.Playback.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Playback.Tests.Shared")]
[assembly: InternalsVisibleTo("SphFluid.Playback.Tests.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Playback.Tests.Runtime")]
