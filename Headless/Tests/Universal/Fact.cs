using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace Headless.Tests.Universal;

/// <summary>What the pipeline sets under a name.</summary>
/// <param name="Name">Of the variable, texture or keyword.</param>
/// <param name="From">The first event at which it has the value of the camera that is drawn.</param>
/// <param name="Formula">In words for the table of facts.</param>
/// <param name="Unit">Of the value; empty where it has none.</param>
/// <param name="Declaration">In HLSL.</param>
/// <param name="Values">Expressions of four numbers.</param>
/// <param name="Expected">The same numbers from what the scene says, computed without the pipeline.</param>
public sealed record Fact(
    string Name, RenderPassEvent From, string Formula, string Unit, string Declaration, string[] Values, Func<FactScene, Vector4[]> Expected)
{
    public override string ToString() => Name;
}
