using System;

namespace Unity.Collections;

[AttributeUsage(AttributeTargets.Field | AttributeTargets.Parameter)]
public sealed class WriteOnlyAttribute : Attribute { }
