package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.minimal.MavType;

/** What moves where, as far as plans care. */
public enum VehicleKind {
    /** It floats. */
    BOAT("boat"),
    /** It drives on land. */
    ROVER("rover"),
    /** It flies and can stand in the air. */
    COPTER("copter"),
    /** It flies and cannot stand in the air, or only changes into what can. */
    PLANE("plane"),
    /** It dives. */
    SUBMARINE("submarine"),
    /** Something else that has an autopilot. */
    OTHER("vehicle");

    private final String word;

    VehicleKind(String word) {
        this.word = word;
    }

    /** One word for people. */
    public String word() {
        return word;
    }

    /** Whether it may fall where its motors are turned off: it flies, or what it is is not known. */
    boolean mayFly() {
        return switch (this) {
            case BOAT, ROVER, SUBMARINE -> false;
            case COPTER, PLANE, OTHER -> true;
        };
    }

    /** Whether one vehicle can say both of itself: a boat is a rover by a parameter, and an autopilot that starts does not know yet what it is. */
    boolean canBe(VehicleKind other) {
        boolean drives = this == BOAT || this == ROVER;
        boolean otherDrives = other == BOAT || other == ROVER;
        return this == other || this == OTHER || other == OTHER || (drives && otherDrives);
    }

    static VehicleKind of(MavType type) {
        return switch (type) {
            case MAV_TYPE_SURFACE_BOAT -> BOAT;
            case MAV_TYPE_GROUND_ROVER -> ROVER;
            case MAV_TYPE_SUBMARINE -> SUBMARINE;
            case MAV_TYPE_QUADROTOR,
                    MAV_TYPE_COAXIAL,
                    MAV_TYPE_HELICOPTER,
                    MAV_TYPE_HEXAROTOR,
                    MAV_TYPE_OCTOROTOR,
                    MAV_TYPE_TRICOPTER,
                    MAV_TYPE_DODECAROTOR,
                    MAV_TYPE_DECAROTOR -> COPTER;
            case MAV_TYPE_FIXED_WING,
                    MAV_TYPE_VTOL_TAILSITTER_DUOROTOR,
                    MAV_TYPE_VTOL_TAILSITTER_QUADROTOR,
                    MAV_TYPE_VTOL_TILTROTOR,
                    MAV_TYPE_VTOL_FIXEDROTOR,
                    MAV_TYPE_VTOL_TAILSITTER,
                    MAV_TYPE_VTOL_TILTWING -> PLANE;
            default -> OTHER;
        };
    }
}
