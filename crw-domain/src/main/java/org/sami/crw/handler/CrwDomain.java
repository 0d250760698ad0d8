package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.sami.crw.decision.DoubtedPaths;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.FleetWants;
import org.sami.crw.fleet.publishing.FleetEvents;
import org.sami.crw.handler.boat.BoatBlocks;
import org.sami.crw.handler.boat.BoatNews;
import org.sami.crw.handler.boat.BoatQuestions;
import org.sami.crw.handler.boat.FlightUseMemory;
import org.sami.crw.handler.boat.NewBoats;
import org.sami.crw.handler.boat.SentLists;
import org.sami.crw.handler.boat.SettingRequests;
import org.sami.crw.handler.boat.TakeOverNews;
import org.sami.crw.handler.boat.UnknownBoats;
import org.sami.crw.handler.motion.AircraftMemory;
import org.sami.crw.handler.motion.BoatErrors;
import org.sami.crw.handler.motion.ClearWays;
import org.sami.crw.handler.motion.ExecutePathHandler;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.handler.motion.WayQuestions;
import org.sami.crw.handler.planning.Computations;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.handler.planning.ExploreAreaHandler;
import org.sami.crw.handler.planning.ExploredAreas;
import org.sami.crw.handler.planning.ServiceThreads;
import org.sami.crw.handler.subscription.AreaSubscriptions;
import org.sami.crw.handler.subscription.BatterySubscriptions;
import org.sami.crw.handler.subscription.MeasurementHandler;
import org.sami.crw.message.MessageSink;
import org.sami.crw.proxy.BoatConnector;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.task.TaskNews;
import org.sami.crw.task.TaskQueues;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.Registration;
import org.sami.spn.value.TaskId;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The boats domain on a host: it registers every handler, passes withdrawals on to the boats, and posts the boats' reports as inputs. All
 * programs that run plans on boats use it, simulated or not.
 *
 * <p>A program makes the host first, then the domain, then the proxies: has them publish to {@link #events} and adds them to the registry. Then
 * the host resumes.
 */
public final class CrwDomain implements AutoCloseable {
    private final Set<String> handlers;
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
        MotionCommands motion =
                new MotionCommands(boats, messages, ways, new ClearWays(boats, messages, errors, events));
        computations = new Computations(fleet, messages, threads);
        SettingRequests settings = new SettingRequests(boats, messages);
        AreaSubscriptions areas = new AreaSubscriptions(boats, fleet);
        MeasurementHandler measurements = new MeasurementHandler(messages, fleet);
        BatterySubscriptions batteries = new BatterySubscriptions(boats, fleet);
        BoatQuestions questions = new BoatQuestions(host, boats, fleet);
        ExploredAreas explored = new ExploredAreas(messages, computations, errors, fleet);
        AircraftMemory aircraft = new AircraftMemory(host, boats, motion.aircraftParts());
        List.<Consumer<FleetEvent>>of(
                        aircraft::load,
                        new FlightUseMemory(host, boats), // these first: others may give the boat commands
                        new BoatBlocks(host, boats),
                        explored,
                        motion,
                        aircraft::save,
                        settings,
                        questions,
                        batteries,
                        areas,
                        measurements,
                        new BoatNews(host, newBoats, messages, batteries),
                        new TakeOverNews(host, boats),
                        new SentLists(host, boats))
                .forEach(events::passTo);
        tasks = new TaskQueues(host, (news, names) -> fleet.execute(() -> publish(news, names, motion)));

        DomainHandlers all = new DomainHandlers(boats, messages, services, errors, motion, computations);
        all.addMotion();
        all.addExploration(explored);
        HandlerParts.Added own = ofDomain(new HandlerParts(
                host, boats, fleet, messages, motion, computations, services, errors, new HandlerParts.Added()));
        own.fleetListeners.forEach(events::passTo);
        Set<String> moving = new HashSet<>(all.types());
        moving.addAll(own.motion);
        Withdrawals withdrawals = new Withdrawals(moving, motion, computations, fleet);
        all.addPlanning();
        all.addAborts(own.laterMoves);
        all.addBoats(connector, newBoats, settings);
        all.addSubscriptions(areas, measurements, batteries);
        all.addMissions(tasks);
        all.add(own.handlers);
        handlers = all.types();

        all.registerOn(host, fleet, registrations);
        listen(host, withdrawals, computations, explored);
        registrations.add(computations::close);
        own.hostListeners.forEach(listener -> listen(host, listener));
        listen(host, questions, ways, new UnknownBoats(host, fleet), tasks, batteries, areas, measurements);
    }

    /** What the modules of the host's domain, and of those that it combines, add. */
    private static HandlerParts.Added ofDomain(HandlerParts parts) {
        Vocabulary vocabulary = parts.host().ask(EngineView::vocabulary);
        HandlerModules.of(vocabulary).forEach(module -> module.addTo(parts));
        return parts.added();
    }

    private void publish(TaskNews news, List<TaskId> names, MotionCommands motion) {
        events.onTask(news, names);
        if (news.kind() == TaskNews.Kind.RELEASED) {
            motion.release(news.boat(), names);
        }
    }

    private void listen(EngineHost host, HostListener... listeners) {
        for (HostListener listener : listeners) {
            registrations.add(host.addListener(listener));
        }
    }

    /**
     * Puts the domain on a host with the standard services.
     *
     * @param boats filled by the caller, now or later
     * @param fleet the serial executor that drives the proxies of {@code boats}; handlers run there
     * @param messages receives the messages to the operator
     */
    public static CrwDomain install(EngineHost host, ProxyRegistry boats, Executor fleet, MessageSink messages) {
        return install(host, boats, fleet, messages, CrwServices.STANDARD, BoatConnector.NONE);
    }

    /**
     * Puts the domain on a host.
     *
     * @param connector connects plans to more boats
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
     * @param events receives the reports of all boats from their proxies and passes them to the domain
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
     * Puts the domain on the host of a session in real time, whose services compute on threads of their own.
     *
     * @param threads those threads; closed by the caller, after the domain
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
     * The same for a base that connects to more boats while it runs.
     *
     * @param connector connects plans to them
     * @param events receives the reports of all boats from their proxies and passes them to the domain
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

    /** The events of the boats and their tasks. Every proxy of the registry publishes there, on the fleet's thread. */
    public FleetEvents events() {
        return events;
    }

    /** The boats' tasks. */
    public TaskQueues tasks() {
        return tasks;
    }

    /**
     * The paths of the boats that wait for the answer to a question about their ways; empty without any. On the fleet's thread.
     *
     * @param kind of the question
     * @param about its subject
     */
    public Optional<DoubtedPaths> doubtedPaths(String kind, String about) {
        return ways.doubted(kind, about);
    }

    /** Whether a service computes for a mission now, so that commands or answers will follow; from any thread. */
    public boolean isComputing() {
        return computations.areUnderWay();
    }

    /** Commands, computations and questions that missions wait for outside the engine; on the fleet's thread. */
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
        return handlers;
    }

    /** Removes handlers and listeners from the host; commands that boats have already received go on. */
    @Override
    public void close() {
        registrations.forEach(Registration::close);
    }
}
