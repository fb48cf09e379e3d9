using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

[DefaultExecutionOrder(-10)]
public class EarlyProbe : Probe { }
