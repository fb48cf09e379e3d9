using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("SphFluid.Thesis.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Tests.Shared")]
[assembly: InternalsVisibleTo("SphFluid.Tests.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Tests.Runtime")]
[assembly: InternalsVisibleTo("SphFluid.Thesis.Tests.Editor")]
[assembly: InternalsVisibleTo("SphFluid.Validation.Laboratory")]
