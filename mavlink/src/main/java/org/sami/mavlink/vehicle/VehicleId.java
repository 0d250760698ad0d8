package org.sami.mavlink.vehicle;

/** Names a vehicle on the links of one base: the system id of its autopilot (1 to 254) and the autopilot's component id (1 nearly always). */
public record VehicleId(int system, int component) implements Comparable<VehicleId> {
    private static final int AUTOPILOT = 1;

    @Override
    public int compareTo(VehicleId other) {
        return system != other.system
                ? Integer.compare(system, other.system)
                : Integer.compare(component, other.component);
    }

    /** The system id, and the component id where it is not the usual one. */
    @Override
    public String toString() {
        return component == AUTOPILOT ? Integer.toString(system) : system + "." + component;
    }
}
