using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("SphFluid.Thesis.Tests.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Tests.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Tests.Runtime")]
[assembly: InternalsVisibleTo("SphFluid.Tests.Universal")]
[assembly: InternalsVisibleTo("SphFluid.Validation.Tests.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Validation.Tests.Runtime")]
[assembly: InternalsVisibleTo("SphFluid.Playback.Tests.Shared")]
[assembly: InternalsVisibleTo("SphFluid.Playback.Tests.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Playback.Tests.Runtime")]
[assembly: InternalsVisibleTo("SphFluid.PySph.Tests.Editor")]
[assembly: InternalsVisibleTo("SphFluid.PySph.Tests.Runtime")]
