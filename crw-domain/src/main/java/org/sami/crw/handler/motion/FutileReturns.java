package org.sami.crw.handler.motion;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.link.BatteryLevel;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.path.Detour;
import org.sami.crw.service.reach.Charge;
import org.sami.crw.service.reach.WayDoubt;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.GeoPoint;

/**
 * Boats that turn critical on their paths, get a new battery, and set out again: who has come back twice without having visited any more is doubted
 * when it is sent the third time (docs/services.md). A boat that is then sent all the same goes without coming home until it has visited one point more;
 * its mission's memory says so, for whoever pulls out boats whose batteries are critical. Counts are not journalled: after a restart of the base they
 * begin again. For the fleet's thread.
 */
final class FutileReturns {
    private static final int TOLERATED = 2;

    private final ProxyRegistry boats;
    private final Map<String, Attempt> attempts = new HashMap<>();
    private final Map<String, Excused> excused = new HashMap<>();

    /**
     * A boat that was sent along a path.
     *
     * @param visited points of the path behind it
     * @param returns how often it came back with a critical battery before it was sent
     * @param turnedCritical whether its battery was critical at some time since
     * @param cameBack whether it was sent because it had come back so
     */
    private record Attempt(String path, int visited, int returns, boolean turnedCritical, boolean cameBack) {
        Attempt critical() {
            return new Attempt(path, visited, returns, true, cameBack);
        }

        Attempt again(boolean isCritical) {
            boolean back = turnedCritical && !isCritical;
            return new Attempt(path, visited, returns + (back ? 1 : 0), isCritical, back);
        }
    }

    private record Excused(long mission, HandlerContext context) {}

    FutileReturns(ProxyRegistry boats) {
        this.boats = boats;
    }

    /** The key in a mission's memory that says whether a boat goes on with a critical battery. */
    static String key(String boat) {
        return WithoutComingHome.KEY + boat;
    }

    /** Counts that a boat is about to be sent; says what is wrong where it has come back too often. */
    Optional<WayDoubt> doubt(Move move) {
        if (move.progress().isEmpty() || !(move.command() instanceof FollowPath path) || path.nothingIsLeft()) {
            return Optional.empty();
        }
        String boat = move.addressee().boat();
        PathProgress.Along along = move.progress().get();
        Attempt first = new Attempt(along.key(), along.behind() + path.startIndex(), 0, isCritical(boat), false);
        Attempt now = Optional.ofNullable(attempts.get(boat))
                .filter(before -> before.path.equals(first.path) && before.visited == first.visited)
                .map(before -> before.again(first.turnedCritical))
                .orElse(first);
        attempts.put(boat, now);
        return now.cameBack && now.returns >= TOLERATED ? Optional.of(doubt(boat, path)) : Optional.empty();
    }

    private boolean isCritical(String boat) {
        return boats.find(boat)
                .flatMap(proxy -> proxy.status().battery())
                .filter(battery -> battery.level() == BatteryLevel.CRITICAL)
                .isPresent();
    }

    private WayDoubt doubt(String boat, FollowPath path) {
        GeoPoint next = path.unvisitedPoints().get(0);
        Optional<BoatProxy> proxy = boats.find(boat);
        Optional<GeoPoint> from = proxy.flatMap(one -> one.status().pose()).map(BoatPose::position);
        Optional<GeoPoint> home = proxy.flatMap(BoatProxy::home);
        Optional<Charge> charge = proxy.flatMap(BoatProxy::charge);
        String words = boat + " came back twice with a critical battery and had visited nothing more: ";
        if (from.isEmpty() || home.isEmpty() || charge.isEmpty()) {
            return new WayDoubt(WayDoubt.Kind.NO_HEADWAY, words + "its next point is far away");
        }
        double outM = Geodesy.lengthM(from.get(), Detour.along(from.get(), List.of(next), path.water()));
        double backM = Geodesy.lengthM(
                next, Detour.along(next, List.of(home.get()), path.water().map(water -> water.leaving(home.get()))));
        double left = charge.get().percent() - charge.get().usedPercent(outM + backM);
        String way = String.format(Locale.ROOT, "its next point is %.0f m away and %.0f m from home, ", outM, backM);
        return left > 0
                ? new WayDoubt(
                        WayDoubt.Kind.NO_HEADWAY,
                        words + way + String.format(Locale.ROOT, "from where it comes home with about %.0f %%", left))
                : new WayDoubt(
                        WayDoubt.Kind.ONE_WAY,
                        words
                                + way
                                + String.format(
                                        Locale.ROOT,
                                        "and its charge lasts for about %.0f m: it would have to be fetched",
                                        charge.get().meanM()));
    }

    /** The operator wants a boat to go all the same. */
    void excuse(String boat, long mission, HandlerContext context) {
        excused.put(boat, new Excused(mission, context));
        context.post(new Input.Remember(mission, key(boat), new BooleanValue(true)));
    }

    void accept(FleetEvent event) {
        if (event instanceof FleetEvent.BatteryReported reported
                && reported.battery().level() == BatteryLevel.CRITICAL) {
            attempts.computeIfPresent(reported.boat(), (boat, attempt) -> attempt.critical());
        } else if (event instanceof FleetEvent.Progressed progressed) {
            over(progressed.boat());
        } else if (event instanceof FleetEvent.CommandCompleted completed) {
            over(completed.boat());
        }
    }

    private void over(String boat) {
        Excused one = excused.remove(boat);
        if (one != null) {
            one.context.post(new Input.Remember(one.mission, key(boat), new BooleanValue(false)));
        }
    }
}
