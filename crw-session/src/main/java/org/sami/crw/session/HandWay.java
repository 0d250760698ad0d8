package org.sami.crw.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.handler.motion.WayLimits;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.path.Detour;
import org.sami.crw.service.reach.Charge;
import org.sami.crw.service.reach.Endurance;
import org.sami.crw.service.reach.Flight;
import org.sami.crw.service.reach.FlightCheck;
import org.sami.crw.service.reach.Way;
import org.sami.crw.service.reach.WayBack;
import org.sami.crw.service.reach.WayCheck;
import org.sami.crw.service.reach.WayDanger;
import org.sami.crw.service.reach.WayDoubt;
import org.sami.crw.service.water.Water;
import org.sami.session.api.BoatStart;
import org.sami.session.api.RefusedException;
import org.sami.session.api.WayByHand;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Finds the way on which an operator sends a boat to a point, and what is to be doubted of it. */
final class HandWay {
    private static final double FLIGHT_M = 20; // at least, of what takes off by hand
    private static final double AIRBORNE_M = 1;

    private HandWay() {}

    /** Where a boat is, if that is known; one that does not say how far it may be off its ways is as the services have it. */
    static Optional<BoatStart> startOf(BoatProxy boat, CrwServices services) {
        return boat.status()
                .pose()
                .map(BoatPose::position)
                .map(at -> new BoatStart(at, boat.errorOr(services.error())));
    }

    /**
     * What a way begins with.
     *
     * @param charge that of the battery of a boat that pays for its way, if it is known
     * @param home where the boat returns to, if that is known
     * @param flies whether it does: it goes through the air then, and lands only at its home
     * @param endurance how long it stays in the air; empty for what does not fly, or where that is not known
     * @param speedMps its speed on the way
     */
    record Start(
            String boat,
            BoatStart at,
            Optional<Charge> charge,
            Optional<GeoPoint> home,
            boolean flies,
            Optional<Endurance> endurance,
            double speedMps) {
        Start {
            Objects.requireNonNull(boat, "boat");
            Objects.requireNonNull(at, "at");
            Objects.requireNonNull(charge, "charge");
            Objects.requireNonNull(home, "home");
            Objects.requireNonNull(endurance, "endurance");
        }

        /** Whether its charge does not last for the flight and the way home; empty where it does. */
        Optional<WayDoubt> flightDoubt(FollowPath command) {
            GeoPoint from = at.at();
            Optional<GeoPoint> landing = from.altM() < AIRBORNE_M ? Optional.of(from) : home;
            return endurance.flatMap(lasts -> FlightCheck.doubt(
                    new Flight(boat, from, command.points(), speedMps, 0, landing, command.water()), lasts));
        }

        /** Where it goes to come to a point: what flies keeps its altitude, or takes off. */
        List<GeoPoint> to(GeoPoint point) {
            double altM = Math.max(point.altM(), Math.max(at.at().altM(), FLIGHT_M));
            return List.of(flies ? new GeoPoint(point.latDeg(), point.lonDeg(), altM) : point);
        }

        /**
         * Where an aircraft goes to land where it took off.
         *
         * @throws RefusedException where it is on the ground, or has not said where that is
         */
        List<GeoPoint> back() {
            if (at.at().altM() < AIRBORNE_M) {
                throw new RefusedException(boat + " is on the ground");
            }
            GeoPoint ground = home.orElseThrow(() -> new RefusedException(boat + " has not said where it took off"));
            List<GeoPoint> way = new ArrayList<>(to(ground));
            way.add(new GeoPoint(ground.latDeg(), ground.lonDeg(), 0));
            return way;
        }
    }

    /**
     * The command that sends the boat there. Computes ways around no-go areas.
     *
     * @throws RefusedException where the point lies in a no-go area, or where there is no way
     */
    static FollowPath command(String id, Start start, List<GeoPoint> way, WayLimits limits) {
        FollowPath command = FollowPath.of(id, Ids.NONE, Ids.NONE, way, Priority.CRITICAL);
        GeoPoint to = way.get(0);
        GeoPoint from = start.at().at();
        Optional<Water> water =
                limits.water(Optional.of(from), List.of(to), start.at().error()).filter(one -> !one.isOpen());
        if (water.isEmpty()) {
            return command;
        }
        if (!water.get().allows(List.of(to))) {
            throw new RefusedException(String.format(
                    Locale.ROOT,
                    "%s is not sent: %s lies %.1f m inside what is to be avoided",
                    start.boat(),
                    text(to),
                    water.get().depthM(to)));
        }
        boolean isBarred = !water.get().allows(List.of(from, to))
                && Detour.between(from, to, water.get()).isEmpty();
        if (isBarred) {
            throw new RefusedException(String.format(
                    "%s is not sent: around what is to be avoided there is no way to %s", start.boat(), text(to)));
        }
        return command.in(water.get());
    }

    /** The way of such a command. */
    static WayByHand of(Start start, FollowPath command, Optional<GeoArea> fence) {
        GeoPoint from = start.at().at();
        GeoPoint to = command.points().get(0);
        List<GeoPoint> points = new ArrayList<>(List.of(from));
        points.addAll(command.way(from));
        Way way =
                new Way(start.boat(), Optional.of(from), start.charge(), command.points(), List.of(), command.water());
        List<String> doubts = new ArrayList<>();
        fence.flatMap(area -> new WayLimits(List.of(), fence)
                        .water(Optional.empty(), command.points(), start.at().error()))
                .filter(Water::isOpen) // who is sent outside is not kept in
                .ifPresent(outside -> doubts.add("is sent to " + text(to) + ", which lies outside of the fence"));
        command.water()
                .ifPresent(water ->
                        WayDanger.of(from, command.points(), water).forEach(danger -> doubts.add(danger.words())));
        Optional<WayDoubt> flight = start.flightDoubt(command);
        Optional<WayDoubt> doubt =
                WayCheck.doubt(way).map(first -> first.and(flight)).or(() -> flight);
        doubt.ifPresent(one -> doubts.add(one.words()));
        start.home()
                .flatMap(home -> WayBack.of(way, home))
                .filter(back -> doubt.isEmpty() && !back.isSure())
                .ifPresent(back -> doubts.add(back.words()));
        return new WayByHand(points, doubts);
    }

    private static String text(GeoPoint point) {
        return String.format(Locale.ROOT, "%.5f,%.5f", point.latDeg(), point.lonDeg());
    }
}
