namespace UnityEngine;
public class Collider : Component { }
public class BoxCollider : Collider { }
public class SphereCollider : Collider { }
public class CapsuleCollider : Collider { public float height {get;set;} }
public class MeshCollider : Collider { }
