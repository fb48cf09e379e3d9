using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("SphFluid.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Universal")]
[assembly: InternalsVisibleTo("SphFluid.Tests.Shared")]
[assembly: InternalsVisibleTo("SphFluid.Tests.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Tests.Runtime")]
