using System;

namespace UnityEngine;

public partial class Transform
{
    public Vector3 TransformPoint(Vector3 position) => localToWorldMatrix.MultiplyPoint3x4(position);
    public Vector3 TransformPoint(float x, float y, float z) => TransformPoint(new Vector3(x, y, z));
    public Vector3 InverseTransformPoint(Vector3 position) => worldToLocalMatrix.MultiplyPoint3x4(position);
    public Vector3 InverseTransformPoint(float x, float y, float z) => InverseTransformPoint(new Vector3(x, y, z));
    public Vector3 TransformVector(Vector3 vector) => localToWorldMatrix.MultiplyVector(vector);
    public Vector3 TransformVector(float x, float y, float z) => TransformVector(new Vector3(x, y, z));
    public Vector3 InverseTransformVector(Vector3 vector) => worldToLocalMatrix.MultiplyVector(vector);
    public Vector3 InverseTransformVector(float x, float y, float z) => InverseTransformVector(new Vector3(x, y, z));
    public Vector3 TransformDirection(Vector3 direction) => rotation * direction;
    public Vector3 TransformDirection(float x, float y, float z) => TransformDirection(new Vector3(x, y, z));
    public Vector3 InverseTransformDirection(Vector3 direction) => Quaternion.Inverse(rotation) * direction;
    public Vector3 InverseTransformDirection(float x, float y, float z) => InverseTransformDirection(new Vector3(x, y, z));

    public void TransformPoints(Span<Vector3> positions) => TransformPoints(positions, positions);

    public void TransformPoints(ReadOnlySpan<Vector3> positions, Span<Vector3> transformedPositions)
    {
        Matrix4x4 matrix = localToWorldMatrix;
        for (int i = 0; i < positions.Length; i++) transformedPositions[i] = matrix.MultiplyPoint3x4(positions[i]);
    }

    public void InverseTransformPoints(Span<Vector3> positions) => InverseTransformPoints(positions, positions);

    public void InverseTransformPoints(ReadOnlySpan<Vector3> positions, Span<Vector3> transformedPositions)
    {
        Matrix4x4 matrix = worldToLocalMatrix;
        for (int i = 0; i < positions.Length; i++) transformedPositions[i] = matrix.MultiplyPoint3x4(positions[i]);
    }

    public void Translate(Vector3 translation) => Translate(translation, Space.Self);
    public void Translate(float x, float y, float z) => Translate(new Vector3(x, y, z), Space.Self);
    public void Translate(float x, float y, float z, Space relativeTo) => Translate(new Vector3(x, y, z), relativeTo);
    public void Translate(float x, float y, float z, Transform relativeTo) => Translate(new Vector3(x, y, z), relativeTo);

    public void Translate(Vector3 translation, Space relativeTo) =>
        position += relativeTo == Space.World ? translation : TransformDirection(translation);

    public void Translate(Vector3 translation, Transform relativeTo) =>
        position += relativeTo ? relativeTo.TransformDirection(translation) : translation;

    public void Rotate(Vector3 eulers) => Rotate(eulers, Space.Self);
    public void Rotate(float xAngle, float yAngle, float zAngle) => Rotate(new Vector3(xAngle, yAngle, zAngle), Space.Self);
    public void Rotate(float xAngle, float yAngle, float zAngle, Space relativeTo) => Rotate(new Vector3(xAngle, yAngle, zAngle), relativeTo);
    public void Rotate(Vector3 axis, float angle) => Rotate(axis, angle, Space.Self);

    public void Rotate(Vector3 eulers, Space relativeTo)
    {
        Quaternion turn = Quaternion.Euler(eulers);
        if (relativeTo == Space.Self) localRotation *= turn;
        else rotation = turn * rotation;
    }

    public void Rotate(Vector3 axis, float angle, Space relativeTo)
    {
        Quaternion turn = Quaternion.AngleAxis(angle, axis);
        if (relativeTo == Space.Self) localRotation *= turn;
        else rotation = turn * rotation;
    }

    public void RotateAround(Vector3 point, Vector3 axis, float angle)
    {
        Quaternion turn = Quaternion.AngleAxis(angle, axis);
        Vector3 newPosition = point + turn * (position - point);
        rotation = turn * rotation;
        position = newPosition;
    }

    public void LookAt(Transform target) => LookAt(target, Vector3.up);
    public void LookAt(Transform target, Vector3 worldUp) { if (target) LookAt(target.position, worldUp); }
    public void LookAt(Vector3 worldPosition) => LookAt(worldPosition, Vector3.up);

    public void LookAt(Vector3 worldPosition, Vector3 worldUp)
    {
        Vector3 direction = worldPosition - position;
        if (direction.sqrMagnitude > 0f) rotation = Quaternion.LookRotation(direction, worldUp);
    }
}
