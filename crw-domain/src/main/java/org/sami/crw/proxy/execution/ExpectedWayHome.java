package org.sami.crw.proxy.execution;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.MotionDefaults;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

/**
 * The way on which a boat is expected to return home by itself when its link is lost. As the boat does, it takes the shortest from the last position
 * among the ways sent for the current or last leg (docs/link.md).
 */
public final class ExpectedWayHome {
    private final Supplier<Optional<GeoPoint>> home;
    private boolean isTaken = true;
    private String listId = "";
    private List<List<List<GeoPoint>>> ofLegs = List.of(); // each way as the turns before home
    private int leg;
    private List<GeoPoint> way = List.of();

    /**
     * Knows no way but the straight one.
     *
     * @param home gives where the boat returns to, if that is known
     */
    public ExpectedWayHome(Supplier<Optional<GeoPoint>> home) {
        this.home = home;
    }

    /** Where the boat returns to, if that is known. */
    Optional<GeoPoint> home() {
        return home.get();
    }

    /** Whether the boat takes ways home, as far as it has said; it comes straight home where it takes none. */
    boolean isTaken() {
        return isTaken;
    }

    /** The boat says whether it takes ways home. */
    public void isTaken(boolean now) {
        isTaken = now;
    }

    /** The boat has the ways home from a list. */
    void has(String ofList, List<List<List<GeoPoint>>> ways) {
        listId = ofList;
        ofLegs = List.copyOf(ways);
    }

    /** The boat has started a list at a point; the ways of another list are over. */
    void started(String startedList, int index) {
        if (!startedList.equals(listId)) {
            has(startedList, List.of());
        }
        leg = index;
    }

    /** The boat drives to that point of the list. */
    void drivesTo(int index) {
        leg = index;
    }

    /** The boat is expected to come home from now on, from where it was seen last. */
    public void begin(Optional<GeoPoint> from) {
        way = from.isPresent() && home.get().isPresent()
                ? way(from.get(), home.get().get())
                : List.of();
    }

    /** The boat does something else. */
    void end() {
        way = List.of();
    }

    /** The boat says what it does. */
    public void says(BoatMode mode) {
        if (mode != BoatMode.RETURN) {
            end();
        }
    }

    /** From where the boat was seen last to its home, with the turns between; empty where it is not expected to come home. */
    public List<GeoPoint> way() {
        return way;
    }

    private List<GeoPoint> way(GeoPoint from, GeoPoint to) {
        if (Geodesy.distanceM(from, to) < MotionDefaults.ARRIVAL_RADIUS_M) {
            return List.of();
        }
        List<List<GeoPoint>> known = ofLegs.isEmpty() ? List.of() : ofLegs.get(Math.min(leg, ofLegs.size() - 1));
        List<GeoPoint> shortest = List.of();
        double leastM = Double.POSITIVE_INFINITY;
        for (List<GeoPoint> turns : known) {
            List<GeoPoint> rest = new ArrayList<>(turns);
            rest.add(to);
            double lengthM = Geodesy.lengthM(from, rest);
            if (lengthM < leastM) {
                leastM = lengthM;
                shortest = turns;
            }
        }
        List<GeoPoint> whole = new ArrayList<>(List.of(from));
        whole.addAll(shortest);
        whole.add(to);
        return Collections.unmodifiableList(whole);
    }
}
