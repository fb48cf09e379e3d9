using UnityEngine;

namespace UnityEditor.SceneManagement;

public static class StageUtility
{
    public static void PlaceGameObjectInCurrentStage(GameObject gameObject) { }
}
