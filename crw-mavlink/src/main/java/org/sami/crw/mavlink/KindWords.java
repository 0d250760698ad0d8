package org.sami.crw.mavlink;

import org.sami.crw.fleet.RobotKind;
import org.sami.mavlink.vehicle.VehicleKind;

/** What a vehicle is, for texts in which its kind is the point: sessions of copters put their word in place of the word for a boat, but not in place of these. */
final class KindWords {
    private KindWords() {}

    static String of(VehicleKind kind) {
        return kind == VehicleKind.BOAT ? RobotKind.SURFACE_BOAT : kind.word();
    }

    /** Of a boat, or of a copter. */
    static String of(VehicleOwner owner) {
        return owner.flies() ? RobotKind.COPTER.word() : RobotKind.SURFACE_BOAT;
    }
}
