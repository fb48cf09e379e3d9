using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("SphFluid.PySph.Tests.Editor")]
