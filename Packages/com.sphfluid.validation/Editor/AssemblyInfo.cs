using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("SphFluid.Validation.Tests.Editor")]
