package org.sami.crw.handler.motion;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.reach.WayDoubt;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * Judges moves to places that a program chooses and changes within seconds, as of a robot that follows another one. The operator is asked about none of them: a
 * question would be about a place that has changed before it is answered. So all that would be asked about speaks against such a move, and so do the areas to stay in,
 * of the plan and of the session's fence, which do not keep in what a person sends outside. For the fleet's thread.
 */
final class UnaskedMoves {
    private final ClearWays clearWays;
    private final WayQuestions questions;
    private final BoatErrors errors;

    UnaskedMoves(ClearWays clearWays, WayQuestions questions, BoatErrors errors) {
        this.clearWays = clearWays;
        this.questions = questions;
        this.errors = errors;
    }

    /**
     * What became of a move.
     *
     * @param move with the water in which it leads
     * @param refusal what speaks against it, a clause that names the robot; empty where nothing does
     */
    record Judged(Move move, Optional<String> refusal) {}

    /** Judges a move of a robot that is somewhere. */
    Judged judge(Activation activation, HandlerContext context, Move move, GeoPoint from) {
        List<GeoArea> kept = context.query(view -> areasToStayIn(activation, view));
        WayLimits limits = new WayLimits(
                context.query(view -> PlanAreas.avoided(activation, view)),
                kept.stream().findFirst());
        Move limited = clearWays.limit(limits, move);
        try {
            Optional<String> refusal = questions
                    .doubt(activation, context, limited)
                    .map(WayDoubt::words)
                    .or(() -> leaving(limited, from, kept))
                    .or(() -> tooNear(limited));
            return new Judged(limited, refusal);
        } catch (IllegalArgumentException crossed) { // it is not known what is to be kept clear of
            return new Judged(limited, Optional.of(String.valueOf(crossed.getMessage())));
        }
    }

    private static List<GeoArea> areasToStayIn(Activation activation, EngineView view) {
        return Stream.of(
                        PlanAreas.within(activation, view),
                        OperatingArea.of(view).fence())
                .flatMap(Optional::stream)
                .distinct()
                .toList();
    }

    private Optional<String> leaving(Move move, GeoPoint from, List<GeoArea> kept) {
        return kept.stream()
                .map(area -> Water.of(from, List.of(), Optional.of(area)))
                .filter(inside -> leaves(move, from, inside))
                .findFirst()
                .map(inside -> move.addressee().boat() + " is to go to " + text(end(move))
                        + ", and leave the area in which it is to stay");
    }

    /** Who is outside comes in on any way. */
    private boolean leaves(Move move, GeoPoint from, Water inside) {
        GeoPoint end = end(move);
        CrossTrackError error = errors.of(move.addressee().boat());
        boolean endsInside =
                inside.clearanceM(end) >= inside.drivenWith(error).margin().pathM();
        boolean comesFromInside = inside.allows(List.of(from));
        return !endsInside
                || (comesFromInside
                        && !inside.allows(Stream.concat(Stream.of(from), way(move, from).stream())
                                .toList()));
    }

    private static Optional<String> tooNear(Move move) {
        GeoPoint end = end(move);
        return move.command()
                .water()
                .filter(water -> water.clearanceM(end) < water.margin().pathM())
                .map(water -> String.format(
                        Locale.ROOT,
                        "%s is to go to %s, %.1f m off a no-go area, where it may come into it",
                        move.addressee().boat(),
                        text(end),
                        water.clearanceM(end)));
    }

    private static List<GeoPoint> way(Move move, GeoPoint from) {
        return move.command() instanceof FollowPath path
                ? path.way(from)
                : move.command().unvisitedPoints();
    }

    private static GeoPoint end(Move move) {
        List<GeoPoint> points = move.command().unvisitedPoints();
        return points.get(points.size() - 1);
    }

    private static String text(GeoPoint point) {
        return String.format(Locale.ROOT, "%.5f,%.5f", point.latDeg(), point.lonDeg());
    }
}
