package org.sami.crw.session;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.LongSupplier;
import java.util.stream.Stream;
import org.sami.boat.link.MotionDefaults;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.handler.motion.WayLimits;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.operator.OperatorLog;
import org.sami.crw.operator.OperatorLogEntry.Kind;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyCommands;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.command.KeepStation;
import org.sami.session.api.BoatStart;
import org.sami.session.api.GuidedBoats;
import org.sami.session.api.RefusedException;
import org.sami.session.api.WayByHand;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * What an operator wants of boats without a plan (docs/session.md). It comes before what missions want, which waits and goes on
 * afterwards; the latest wish replaces the one before. Methods may be called from any thread and return at once; what comes of them arrives on the
 * front's executor, a refusal as a {@link RefusedException}.
 */
public final class ByHand implements GuidedBoats {
    private static final String GUIDED = "guided-"; // begins the ids of its commands

    private final Fleet fleet;
    private final EngineHost host;
    private final CrwServices services;
    private final OperatorLog log;
    private final MessageSink messages;
    private final LongSupplier nowMillis;
    private final Replies replies;
    private final Executor computing;
    private final AtomicLong wishes = new AtomicLong();
    private final Map<String, String> latest = new ConcurrentHashMap<>(); // the command of the latest wish, by boat

    /**
     * Sends boats of a fleet.
     *
     * @param computing finds ways
     */
    ByHand(
            Fleet fleet,
            SessionEngine engine,
            CrwServices services,
            OperatorLog log,
            MessageSink messages,
            LongSupplier nowMillis,
            Executor computing) {
        this.fleet = fleet;
        this.services = services;
        this.log = log;
        this.messages = messages;
        this.nowMillis = nowMillis;
        this.computing = computing;
        host = engine.host();
        replies = engine.replies();
    }

    private record Limits(WayLimits way, OperatingArea area) {}

    private record Found(FollowPath command, WayByHand way) {}

    /**
     * Has a boat go to a point, around the project's no-go areas and what the missions avoid in which it takes part; in the fence, unless it is outside
     * or is sent there. Refused where the point lies in such an area, or where there is no way around: nothing is sent then. A message tells what is to
     * be feared on the way, if anything is.
     */
    @Override
    public CompletionStage<WayByHand> goTo(String boat, GeoPoint point) {
        return go(boat, start -> start.to(point), words(boat, point));
    }

    @Override
    public CompletionStage<WayByHand> goHome(String boat) {
        return go(boat, HandWay.Start::back, "sent " + boat + " home");
    }

    private CompletionStage<WayByHand> go(String boat, Function<HandWay.Start, List<GeoPoint>> way, String words) {
        String command = wish(boat);
        return onBoat(boat, this::start)
                .thenCombine(
                        replies.of(host.query(view -> limits(boat, view))),
                        (start, limits) -> replies.on(computing, () -> {
                            FollowPath path = HandWay.command(command, start, way.apply(start), limits.way());
                            return new Found(
                                    path, HandWay.of(start, path, limits.area().fence()));
                        }))
                .thenCompose(Function.identity())
                .thenCompose(found -> tell(boat, words, proxy -> {
                            if (command.equals(latest.get(boat))) {
                                proxy.commands().withdraw(Ids.NONE);
                                proxy.commands().submit(found.command());
                                found.way().doubts().forEach(doubt -> tellOf(boat, doubt));
                            }
                        })
                        .thenApply(sent -> found.way()));
    }

    /** Has a boat keep the place where it is, until it is given back. */
    @Override
    public CompletionStage<Void> hold(String boat) {
        String command = wish(boat);
        return tell(boat, "has " + boat + " hold its place", proxy -> {
            GeoPoint here = start(proxy).at().at();
            proxy.commands().withdraw(Ids.NONE);
            proxy.commands()
                    .submit(new KeepStation(
                            command, Ids.NONE, Ids.NONE, here, MotionDefaults.HOLD_RADIUS_M, Priority.CRITICAL, false));
        });
    }

    /** Cancels what the operator asked of a boat: it goes on with the commands of missions, and an aircraft that comes home for want of charge does so. */
    @Override
    public CompletionStage<Void> giveBack(String boat) {
        wish(boat);
        return tell(boat, "let " + boat + " go on with its missions", proxy -> takeBack(proxy.commands()));
    }

    /** Takes back what was ordered by hand. A command home for want of charge is no mission's either, and stays. */
    private static void takeBack(ProxyCommands commands) {
        List<String> ofNoMission = Stream.concat(commands.current().stream(), commands.waiting().stream())
                .filter(command -> command.mission() == Ids.NONE)
                .map(BoatCommand::commandId)
                .toList();
        List<String> byHand =
                ofNoMission.stream().filter(id -> id.startsWith(GUIDED)).toList();
        if (byHand.size() == ofNoMission.size()) {
            commands.withdraw(Ids.NONE); // with the place that a boat holds since it gave such a command up
        } else {
            byHand.forEach(commands::withdraw);
        }
    }

    /** Notes that there is a later wish for a boat. Gives the id of its command: the session's time goes on where an earlier process ended. */
    private String wish(String boat) {
        String command = GUIDED + nowMillis.getAsLong() + "-" + wishes.incrementAndGet() + "-" + boat;
        latest.put(boat, command);
        return command;
    }

    private HandWay.Start start(BoatProxy boat) {
        BoatStart at = HandWay.startOf(boat, services)
                .orElseThrow(() -> new RefusedException(boat.boatId() + " has not said where it is"));
        return new HandWay.Start(
                boat.boatId(),
                at,
                boat.charge().filter(charge -> !boat.isFlying()), // aircraft pay for time
                boat.home(),
                boat.isFlying(),
                boat.endurance(),
                boat.cruiseSpeedMps());
    }

    private static Limits limits(String boat, EngineView view) {
        Set<GeoArea> avoid = new LinkedHashSet<>(PlanAreas.avoided(Ids.NONE, view));
        for (MissionView mission : view.missions()) {
            boolean takesPart =
                    mission.marking().values().stream().anyMatch(tokens -> tokens.contains(new Token.Proxy(boat)));
            if (takesPart) {
                avoid.addAll(PlanAreas.avoided(mission.id(), view));
            }
        }
        OperatingArea area = OperatingArea.of(view);
        return new Limits(new WayLimits(List.copyOf(avoid), area.fence()), area);
    }

    private static String words(String boat, GeoPoint point) {
        return String.format(Locale.ROOT, "sent %s to %.5f,%.5f", boat, point.latDeg(), point.lonDeg());
    }

    private void tellOf(String boat, String doubt) {
        String words = doubt.startsWith(boat + " ") ? doubt : boat + " " + doubt;
        messages.tell(new OperatorMessage(
                nowMillis.getAsLong(),
                Ids.NONE,
                OperatorMessage.Source.DOMAIN,
                Priority.HIGH,
                words,
                List.of(boat),
                ""));
    }

    private CompletionStage<Void> tell(String boat, String done, Consumer<BoatProxy> what) {
        return onBoat(boat, proxy -> {
            what.accept(proxy);
            log.add(Kind.BOAT, done, boat);
            return null;
        });
    }

    private <T> CompletionStage<T> onBoat(String boat, Function<BoatProxy, T> what) {
        return fleet.ask(boats -> what.apply(
                boats.find(boat).orElseThrow(() -> new RefusedException("there is no boat '" + boat + "'"))));
    }
}
