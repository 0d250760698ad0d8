package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Function;
import java.util.stream.Stream;
import org.sami.crw.decision.DoubtedPaths;
import org.sami.crw.fleet.FleetEvents;
import org.sami.crw.handler.boat.BoatNews;
import org.sami.crw.handler.boat.BoatQuestions;
import org.sami.crw.handler.boat.ConnectExistingProxyHandler;
import org.sami.crw.handler.boat.ConnectExistingProxyIdHandler;
import org.sami.crw.handler.boat.CreateSimulatedProxyHandler;
import org.sami.crw.handler.boat.NewBoats;
import org.sami.crw.handler.boat.SentLists;
import org.sami.crw.handler.boat.ServerLinkHandler;
import org.sami.crw.handler.boat.SetDescriptionHandler;
import org.sami.crw.handler.boat.SetGainsHandler;
import org.sami.crw.handler.boat.SettingRequests;
import org.sami.crw.handler.boat.TakeOverNews;
import org.sami.crw.handler.boat.UnknownBoats;
import org.sami.crw.handler.boat.VelocityMultiplierHandler;
import org.sami.crw.handler.motion.AbortHandler;
import org.sami.crw.handler.motion.AbortScope;
import org.sami.crw.handler.motion.BlockMovementHandler;
import org.sami.crw.handler.motion.BoatErrors;
import org.sami.crw.handler.motion.ClearWays;
import org.sami.crw.handler.motion.EmergencyAbortHandler;
import org.sami.crw.handler.motion.ExecutePathHandler;
import org.sami.crw.handler.motion.GotoLatLonHandler;
import org.sami.crw.handler.motion.GotoLocationListHandler;
import org.sami.crw.handler.motion.GotoPointHandler;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.handler.motion.NearPlaces;
import org.sami.crw.handler.motion.PanoramaHandler;
import org.sami.crw.handler.motion.ProxyAbortMissionHandler;
import org.sami.crw.handler.motion.ResendWaypointsHandler;
import org.sami.crw.handler.motion.StationKeepHandler;
import org.sami.crw.handler.motion.WayQuestions;
import org.sami.crw.handler.planning.AllocationHandler;
import org.sami.crw.handler.planning.AssembleHandler;
import org.sami.crw.handler.planning.CompareDistanceHandler;
import org.sami.crw.handler.planning.Computations;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.handler.planning.DistributeHandler;
import org.sami.crw.handler.planning.ExploreAreaHandler;
import org.sami.crw.handler.planning.ExploredAreas;
import org.sami.crw.handler.planning.PathHandler;
import org.sami.crw.handler.planning.ServiceThreads;
import org.sami.crw.handler.subscription.AreaSubscriptions;
import org.sami.crw.handler.subscription.BatterySubscriptions;
import org.sami.crw.handler.subscription.MeasurementHandler;
import org.sami.crw.operator.message.MessageSink;
import org.sami.crw.operator.mission.FleetWants;
import org.sami.crw.proxy.BoatConnector;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.listener.BoatListener;
import org.sami.crw.proxy.listener.BoatListeners;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.BoatPositions;
import org.sami.crw.service.reach.Range;
import org.sami.crw.task.TaskNews;
import org.sami.crw.task.TaskQueues;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.Registration;
import org.sami.spn.value.GeoPoint;

/**
 * The boats domain on a host: every handler registered, withdrawals passed on to the boats, what boats report posted as inputs. The
 * composition of all programs that run plans on boats, simulated or not.
 *
 * <p>Made in this order: the host; this; the proxies, which get {@link #boatListener}, added to the registry; then the host
 * resumes.
 */
public final class CrwDomain implements AutoCloseable {
    private final Map<String, ActivationHandler> handlers = new LinkedHashMap<>();
    private final List<Registration> registrations = new ArrayList<>();
    private final FleetEvents events;
    private final TaskQueues tasks;
    private final Computations computations;
    private final WayQuestions ways;
    private final ProxyRegistry boats;

    private CrwDomain(
            EngineHost host,
            ProxyRegistry boats,
            Executor fleet,
            MessageSink messages,
            CrwServices services,
            BoatConnector connector,
            FleetEvents events,
            Optional<ServiceThreads> threads) {
        this.events = events;
        this.boats = boats;
        NewBoats newBoats = new NewBoats();
        ways = new WayQuestions(
                boats,
                messages,
                fleet,
                Set.of(ExecutePathHandler.TYPE, ExecutePathHandler.BLOCKING_TYPE, ExploreAreaHandler.TYPE));
        BoatErrors errors = new BoatErrors(boats, services.error());
        ClearWays clearWays = new ClearWays(boats, messages, errors, events);
        MotionCommands motion = new MotionCommands(boats, messages, ways, clearWays);
        computations = new Computations(fleet, messages, threads);
        SettingRequests settings = new SettingRequests(boats, messages);
        AreaSubscriptions areas = new AreaSubscriptions(boats, fleet);
        MeasurementHandler measurements = new MeasurementHandler(messages, fleet);
        BoatQuestions questions = new BoatQuestions(host, boats, fleet);
        BatterySubscriptions batteries = new BatterySubscriptions(boats, fleet);
        Function<String, Optional<GeoPoint>> homes = boat -> boats.find(boat).flatMap(BoatProxy::home);
        ExploredAreas explored = new ExploredAreas(messages, computations, errors, fleet);
        events.passTo(new BoatListeners(
                explored,
                motion,
                settings,
                questions,
                batteries,
                areas,
                measurements,
                new BoatNews(host, newBoats, messages, batteries),
                new TakeOverNews(host, boats),
                new SentLists(host, boats)));
        tasks = new TaskQueues(
                host,
                (news, names) -> fleet.execute(() -> {
                    events.onTask(news, names);
                    if (news.kind() == TaskNews.Kind.RELEASED) {
                        motion.release(news.boat(), names);
                    }
                }));
        BoatPositions positions =
                boat -> boats.find(boat).flatMap(proxy -> proxy.status().pose()).map(BoatPose::position);
        NearPlaces near = new NearPlaces(messages, errors);
        handlers.putAll(movers(motion, near));
        handlers.put(
                ExploreAreaHandler.TYPE,
                new ExploreAreaHandler(
                        services.coverage(),
                        positions,
                        motion,
                        messages,
                        computations,
                        errors,
                        boat -> rangeM(boats, boat),
                        homes,
                        explored));
        Withdrawals withdrawals = new Withdrawals(handlers.keySet(), motion, computations, fleet);
        handlers.put(AreaSubscriptions.TYPE, areas);
        handlers.put(MeasurementHandler.TYPE, measurements);
        handlers.put(SetDescriptionHandler.TYPE, new SetDescriptionHandler());
        handlers.put(ServerLinkHandler.DISCONNECT, ServerLinkHandler.disconnecting(boats));
        handlers.put(ServerLinkHandler.RECONNECT, ServerLinkHandler.reconnecting(boats));
        handlers.put(ResendWaypointsHandler.TYPE, new ResendWaypointsHandler(motion));
        handlers.put(SetGainsHandler.TYPE, new SetGainsHandler(settings));
        handlers.put(VelocityMultiplierHandler.TYPE, new VelocityMultiplierHandler(settings));
        handlers.put(
                AllocationHandler.TYPE,
                new AllocationHandler(
                        services.allocation(),
                        positions,
                        boat -> rangeM(boats, boat),
                        homes,
                        messages,
                        computations,
                        errors));
        handlers.put(PathHandler.TYPE, new PathHandler(services.paths(), positions, messages, computations, errors));
        handlers.put(AssembleHandler.TYPE, new AssembleHandler(services.assembly(), positions, near, errors));
        handlers.put(
                DistributeHandler.TYPE,
                new DistributeHandler(services.allocation(), positions, messages, computations, errors, near));
        handlers.put(CompareDistanceHandler.TYPE, new CompareDistanceHandler(positions));
        handlers.put(BatterySubscriptions.TYPE, batteries);
        for (AbortScope scope : AbortScope.values()) {
            handlers.put(scope.type(), new AbortHandler(scope, boats, motion));
        }
        handlers.put(ProxyAbortMissionHandler.TYPE, new ProxyAbortMissionHandler(motion));
        handlers.put(EmergencyAbortHandler.TYPE, new EmergencyAbortHandler(boats));
        handlers.put(DisplayMessageHandler.TYPE, new DisplayMessageHandler(messages));
        handlers.put(ConnectExistingProxyHandler.TYPE, new ConnectExistingProxyHandler(connector, newBoats));
        handlers.put(ConnectExistingProxyIdHandler.TYPE, new ConnectExistingProxyIdHandler(connector, newBoats));
        handlers.put(CreateSimulatedProxyHandler.TYPE, new CreateSimulatedProxyHandler(connector, newBoats));
        handlers.put(TaskCompleteHandler.TYPE, new TaskCompleteHandler());
        handlers.put(RefreshTasksHandler.TYPE, new RefreshTasksHandler(tasks));
        handlers.put(UnknownRequestHandler.TYPE, new UnknownRequestHandler(messages));
        handlers.forEach((type, handler) -> registrations.add(host.register(type, handler, fleet)));
        registrations.add(host.addListener(withdrawals));
        registrations.add(host.addListener(computations));
        registrations.add(host.addListener(explored));
        registrations.add(computations::close);
        registrations.add(host.addListener(questions));
        registrations.add(host.addListener(ways));
        registrations.add(host.addListener(new UnknownBoats(host, fleet)));
        registrations.add(host.addListener(tasks));
        registrations.add(host.addListener(batteries));
        registrations.add(host.addListener(areas));
        registrations.add(host.addListener(measurements));
    }

    private static OptionalDouble rangeM(ProxyRegistry boats, String boat) {
        Optional<BatteryState> battery =
                boats.find(boat).flatMap(proxy -> proxy.status().battery());
        return battery.isPresent() ? OptionalDouble.of(Range.sureM(battery.get().percent())) : OptionalDouble.empty();
    }

    /** The handlers of what moves boats or keeps them: what they ask can be withdrawn. */
    private static Map<String, ActivationHandler> movers(MotionCommands motion, NearPlaces near) {
        Map<String, ActivationHandler> movers = new LinkedHashMap<>();
        movers.put(ExecutePathHandler.TYPE, new ExecutePathHandler(motion, false));
        movers.put(ExecutePathHandler.BLOCKING_TYPE, new ExecutePathHandler(motion, true));
        movers.put(GotoPointHandler.TYPE, new GotoPointHandler(motion, false));
        movers.put(GotoPointHandler.BLOCKING_TYPE, new GotoPointHandler(motion, true));
        movers.put(GotoLatLonHandler.TYPE, new GotoLatLonHandler(motion));
        movers.put(GotoLocationListHandler.TYPE, new GotoLocationListHandler(motion));
        movers.put(StationKeepHandler.TYPE, new StationKeepHandler(motion, near));
        movers.put(PanoramaHandler.TYPE, new PanoramaHandler(motion));
        movers.put(BlockMovementHandler.TYPE, new BlockMovementHandler(motion));
        return movers;
    }

    /**
     * Puts the domain on a host with the standard services.
     *
     * @param boats filled by the caller, now or later
     * @param fleet the serial executor that drives the proxies of {@code boats}: handlers run there
     * @param messages where the operator's messages go
     */
    public static CrwDomain install(EngineHost host, ProxyRegistry boats, Executor fleet, MessageSink messages) {
        return install(host, boats, fleet, messages, CrwServices.STANDARD);
    }

    /** Puts the domain on a host whose boats are settled. */
    public static CrwDomain install(
            EngineHost host, ProxyRegistry boats, Executor fleet, MessageSink messages, CrwServices services) {
        return install(host, boats, fleet, messages, services, BoatConnector.NONE);
    }

    /**
     * Puts the domain on a host.
     *
     * @param connector how plans get to more boats
     */
    public static CrwDomain install(
            EngineHost host,
            ProxyRegistry boats,
            Executor fleet,
            MessageSink messages,
            CrwServices services,
            BoatConnector connector) {
        return install(host, boats, fleet, messages, services, connector, new FleetEvents());
    }

    /**
     * Puts the domain on a host.
     *
     * @param events is told of all boats by the proxies of {@code boats}, and tells the domain
     */
    public static CrwDomain install(
            EngineHost host,
            ProxyRegistry boats,
            Executor fleet,
            MessageSink messages,
            CrwServices services,
            BoatConnector connector,
            FleetEvents events) {
        return new CrwDomain(host, boats, fleet, messages, services, connector, events, Optional.empty());
    }

    /**
     * Puts the domain on the host of a session in real time, whose services compute beside the fleet's thread.
     *
     * @param threads where; closed by the caller, after the domain
     */
    public static CrwDomain installInRealTime(
            EngineHost host,
            ProxyRegistry boats,
            Executor fleet,
            MessageSink messages,
            CrwServices services,
            ServiceThreads threads) {
        return installInRealTime(
                host, boats, fleet, messages, services, BoatConnector.NONE, new FleetEvents(), threads);
    }

    /**
     * The same for a base that gets to more boats while it runs.
     *
     * @param connector how plans get to them
     * @param events is told of all boats by the proxies of {@code boats}, and tells the domain
     */
    public static CrwDomain installInRealTime(
            EngineHost host,
            ProxyRegistry boats,
            Executor fleet,
            MessageSink messages,
            CrwServices services,
            BoatConnector connector,
            FleetEvents events,
            ServiceThreads threads) {
        return new CrwDomain(host, boats, fleet, messages, services, connector, events, Optional.of(threads));
    }

    /** What every proxy of the registry must be given; to be called on the fleet's thread. */
    public BoatListener boatListener() {
        return events.boatListener();
    }

    /** What happens to the boats and their tasks. */
    public FleetEvents events() {
        return events;
    }

    /** The tasks that boats have to do. */
    public TaskQueues tasks() {
        return tasks;
    }

    /**
     * The paths of the boats that wait for the answer to a question about their ways; empty where none do. On the fleet's thread.
     *
     * @param kind of the question
     * @param about its subject
     */
    public Optional<DoubtedPaths> doubtedPaths(String kind, String about) {
        return ways.doubted(kind, about);
    }

    /** Whether a service computes for a mission now, so that commands or answers are to come; from any thread. */
    public boolean isComputing() {
        return computations.areUnderWay();
    }

    /** What is under way for missions beside the engine; on the fleet's thread. */
    public FleetWants wants() {
        Map<Long, Set<String>> commands = new LinkedHashMap<>();
        for (BoatProxy boat : boats.all()) {
            Stream.concat(boat.commands().current().stream(), boat.commands().waiting().stream())
                    .forEach(command -> commands.computeIfAbsent(command.mission(), id -> new LinkedHashSet<>())
                            .add(boat.boatId()));
        }
        return new FleetWants(commands, computations.missions(), ways.missions());
    }

    /** The output events that are handled here, by name. */
    public Set<String> handledTypes() {
        return Set.copyOf(handlers.keySet());
    }

    /** Takes handlers and listeners off the host; what boats have been told goes on. */
    @Override
    public void close() {
        registrations.forEach(Registration::close);
    }
}
