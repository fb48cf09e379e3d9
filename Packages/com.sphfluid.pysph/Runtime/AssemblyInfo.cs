using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("SphFluid.PySph.Editor")]
[assembly: InternalsVisibleTo("SphFluid.PySph.Tests.Editor")]
[assembly: InternalsVisibleTo("SphFluid.PySph.Tests.Runtime")]
