namespace Headless.Tests.UnityEngineApi;

/// <summary>Inherits private messages.</summary>
public class DerivedProbe : Probe { }
