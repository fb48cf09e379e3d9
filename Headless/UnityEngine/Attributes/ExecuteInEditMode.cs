using System;

namespace UnityEngine;

public sealed class ExecuteInEditMode : Attribute { }
