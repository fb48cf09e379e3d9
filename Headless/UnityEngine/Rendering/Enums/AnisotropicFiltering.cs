namespace UnityEngine;

public enum AnisotropicFiltering
{
    Disable = 0,
    Enable = 1,
    ForceEnable = 2,
}
