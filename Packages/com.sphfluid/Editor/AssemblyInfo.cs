using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("SphFluid.Tests.Editor")]
