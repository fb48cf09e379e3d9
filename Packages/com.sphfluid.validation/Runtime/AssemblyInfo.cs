using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("SphFluid.Validation.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Validation.Tests.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Validation.Tests.Runtime")]
