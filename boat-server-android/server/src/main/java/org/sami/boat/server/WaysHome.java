package org.sami.boat.server;

import java.util.Collections;
import java.util.List;
import org.sami.boat.link.SetWaysHome;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * The boat's ways home: those that its base has sent for the current or last leg, and the rest of the one that it is on. Without any, the straight way.
 */
final class WaysHome {
    private final LocalFrame home;
    private String listId = "";
    private List<List<List<Waypoint>>> ofLegs = Collections.emptyList();
    private List<List<Waypoint>> fromHere = Collections.emptyList();

    WaysHome(LocalFrame home) {
        this.home = home;
    }

    /** Takes the ways home for the boat's waypoint list. */
    void set(SetWaysHome ways, int leg) {
        listId = ways.listId();
        ofLegs = ways.ways();
        driveLeg(leg);
    }

    /** A list starts; ways of another list are dropped. */
    void start(String startedListId, int leg) {
        if (!startedListId.equals(listId)) {
            listId = "";
            ofLegs = Collections.emptyList();
        }
        driveLeg(leg);
    }

    /** The boat drives the leg to this waypoint of the started list. */
    void driveLeg(int leg) {
        if (ofLegs.isEmpty()) {
            fromHere = Collections.emptyList();
        } else if (leg < ofLegs.size()) {
            fromHere = ofLegs.get(leg);
        }
    }

    /** The boat is on its way home and still has these turns ahead. */
    void goOn(List<Waypoint> turns) {
        fromHere = Collections.singletonList(turns);
    }

    /** The turns before home on the shortest way from a position; none where that is straight. */
    List<Waypoint> turns(double latDeg, double lonDeg) {
        List<Waypoint> shortest = Collections.emptyList();
        double leastM = Double.POSITIVE_INFINITY;
        for (List<Waypoint> way : fromHere) {
            double lengthM = lengthM(way, latDeg, lonDeg);
            if (lengthM < leastM) {
                leastM = lengthM;
                shortest = way;
            }
        }
        return shortest;
    }

    /** Length of that way in metres; NaN for an unknown position. */
    double lengthM(double latDeg, double lonDeg) {
        return lengthM(turns(latDeg, lonDeg), latDeg, lonDeg);
    }

    private double lengthM(List<Waypoint> turns, double fromLatDeg, double fromLonDeg) {
        double lengthM = 0;
        double eastM = home.eastM(fromLatDeg, fromLonDeg);
        double northM = home.northM(fromLatDeg, fromLonDeg);
        for (Waypoint turn : turns) {
            double turnEastM = home.eastM(turn.latDeg(), turn.lonDeg());
            double turnNorthM = home.northM(turn.latDeg(), turn.lonDeg());
            lengthM += PlaneMath.length(turnEastM - eastM, turnNorthM - northM);
            eastM = turnEastM;
            northM = turnNorthM;
        }
        return lengthM + PlaneMath.length(eastM, northM);
    }
}
