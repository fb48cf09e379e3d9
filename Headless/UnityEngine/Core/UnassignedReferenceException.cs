using System;

namespace UnityEngine;

[Serializable]
public class UnassignedReferenceException : SystemException
{
    public UnassignedReferenceException() : base("A Unity Runtime error occurred!") { }
    public UnassignedReferenceException(string message) : base(message) { }
    public UnassignedReferenceException(string message, Exception innerException) : base(message, innerException) { }
}
