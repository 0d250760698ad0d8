package org.sami.crw.handler;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.stream.Stream;
import org.sami.crw.handler.boat.ConnectExistingProxyHandler;
import org.sami.crw.handler.boat.ConnectExistingProxyIdHandler;
import org.sami.crw.handler.boat.CreateSimulatedProxyHandler;
import org.sami.crw.handler.boat.NewBoats;
import org.sami.crw.handler.boat.ServerLinkHandler;
import org.sami.crw.handler.boat.SetDescriptionHandler;
import org.sami.crw.handler.boat.SetGainsHandler;
import org.sami.crw.handler.boat.SettingRequests;
import org.sami.crw.handler.boat.VelocityMultiplierHandler;
import org.sami.crw.handler.motion.AbortHandler;
import org.sami.crw.handler.motion.AbortScope;
import org.sami.crw.handler.motion.Aborts;
import org.sami.crw.handler.motion.BlockMovementHandler;
import org.sami.crw.handler.motion.BoatErrors;
import org.sami.crw.handler.motion.EmergencyAbortHandler;
import org.sami.crw.handler.motion.ExecutePathHandler;
import org.sami.crw.handler.motion.GotoLatLonHandler;
import org.sami.crw.handler.motion.GotoLocationListHandler;
import org.sami.crw.handler.motion.GotoPointHandler;
import org.sami.crw.handler.motion.LaterMoves;
import org.sami.crw.handler.motion.LeaveAreaHandler;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.handler.motion.NearPlaces;
import org.sami.crw.handler.motion.PanoramaHandler;
import org.sami.crw.handler.motion.ProxyAbortMissionHandler;
import org.sami.crw.handler.motion.ResendWaypointsHandler;
import org.sami.crw.handler.motion.StationKeepHandler;
import org.sami.crw.handler.planning.AllocationHandler;
import org.sami.crw.handler.planning.AssembleHandler;
import org.sami.crw.handler.planning.BoatReach;
import org.sami.crw.handler.planning.CompareDistanceHandler;
import org.sami.crw.handler.planning.Computations;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.handler.planning.DistributeHandler;
import org.sami.crw.handler.planning.ExploreAreaHandler;
import org.sami.crw.handler.planning.ExploredAreas;
import org.sami.crw.handler.planning.PathHandler;
import org.sami.crw.handler.subscription.AreaSubscriptions;
import org.sami.crw.handler.subscription.BatterySubscriptions;
import org.sami.crw.handler.subscription.MeasurementHandler;
import org.sami.crw.message.MessageSink;
import org.sami.crw.proxy.BoatConnector;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.BoatPositions;
import org.sami.crw.task.TaskQueues;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.Registration;

/** The handlers of the domain's output events, by the event's name; {@link CrwDomain} adds them subject by subject. */
final class DomainHandlers {
    private final Map<String, ActivationHandler> byType = new LinkedHashMap<>();
    private final ProxyRegistry boats;
    private final MessageSink messages;
    private final CrwServices services;
    private final BoatErrors errors;
    private final MotionCommands motion;
    private final Computations computations;
    private final NearPlaces near;
    private final BoatPositions positions;
    private final BoatReach reach;

    DomainHandlers(
            ProxyRegistry boats,
            MessageSink messages,
            CrwServices services,
            BoatErrors errors,
            MotionCommands motion,
            Computations computations) {
        this.boats = boats;
        this.messages = messages;
        this.services = services;
        this.errors = errors;
        this.motion = motion;
        this.computations = computations;
        near = new NearPlaces(messages, errors);
        positions =
                boat -> boats.find(boat).flatMap(proxy -> proxy.status().pose()).map(BoatPose::position);
        reach = new BoatReach(boats);
    }

    /** The events handled so far, by name. */
    Set<String> types() {
        return Set.copyOf(byType.keySet());
    }

    /** Registers all handlers on the host, to run on the fleet's thread. */
    void registerOn(EngineHost host, Executor fleet, List<Registration> registrations) {
        byType.forEach((type, handler) -> registrations.add(host.register(type, handler, fleet)));
    }

    /** Adds handlers of the session's own domain, which come before those of the same name here. */
    void add(Map<String, ActivationHandler> others) {
        byType.putAll(others);
    }

    void addMotion() {
        byType.put(ExecutePathHandler.TYPE, new ExecutePathHandler(motion, false));
        byType.put(ExecutePathHandler.BLOCKING_TYPE, new ExecutePathHandler(motion, true));
        byType.put(GotoPointHandler.TYPE, new GotoPointHandler(motion, false));
        byType.put(GotoPointHandler.BLOCKING_TYPE, new GotoPointHandler(motion, true));
        byType.put(GotoLatLonHandler.TYPE, new GotoLatLonHandler(motion));
        byType.put(GotoLocationListHandler.TYPE, new GotoLocationListHandler(motion));
        byType.put(LeaveAreaHandler.TYPE, new LeaveAreaHandler(motion, errors));
        byType.put(StationKeepHandler.TYPE, new StationKeepHandler(motion, near));
        byType.put(PanoramaHandler.TYPE, new PanoramaHandler(motion));
        byType.put(BlockMovementHandler.TYPE, new BlockMovementHandler(motion));
    }

    void addExploration(ExploredAreas explored) {
        byType.put(
                ExploreAreaHandler.TYPE,
                new ExploreAreaHandler(
                        services.coverage(), positions, motion, messages, computations, errors, reach, explored));
    }

    void addPlanning() {
        byType.put(
                AllocationHandler.TYPE,
                new AllocationHandler(services.allocation(), positions, reach, messages, computations, errors));
        byType.put(PathHandler.TYPE, new PathHandler(services.paths(), positions, messages, computations, errors));
        byType.put(AssembleHandler.TYPE, new AssembleHandler(services.assembly(), positions, near, errors));
        byType.put(
                DistributeHandler.TYPE,
                new DistributeHandler(services.allocation(), positions, messages, computations, errors, near));
        byType.put(CompareDistanceHandler.TYPE, new CompareDistanceHandler(positions));
    }

    /**
     * Adds the handlers of aborts.
     *
     * @param others what the session's own domain has robots do later
     */
    void addAborts(List<LaterMoves> others) {
        Aborts aborts = new Aborts(
                boats,
                motion,
                Stream.concat(Stream.of(computations), others.stream()).toList());
        for (AbortScope scope : AbortScope.values()) {
            byType.put(scope.type(), new AbortHandler(scope, boats, aborts));
        }
        byType.put(ProxyAbortMissionHandler.TYPE, new ProxyAbortMissionHandler(aborts));
        byType.put(EmergencyAbortHandler.TYPE, new EmergencyAbortHandler(aborts));
    }

    void addBoats(BoatConnector connector, NewBoats newBoats, SettingRequests settings) {
        byType.put(ConnectExistingProxyHandler.TYPE, new ConnectExistingProxyHandler(connector, newBoats));
        byType.put(ConnectExistingProxyIdHandler.TYPE, new ConnectExistingProxyIdHandler(connector, newBoats));
        byType.put(CreateSimulatedProxyHandler.TYPE, new CreateSimulatedProxyHandler(connector, newBoats));
        byType.put(SetDescriptionHandler.TYPE, new SetDescriptionHandler());
        byType.put(SetGainsHandler.TYPE, new SetGainsHandler(settings));
        byType.put(VelocityMultiplierHandler.TYPE, new VelocityMultiplierHandler(settings));
        byType.put(ServerLinkHandler.DISCONNECT, ServerLinkHandler.disconnecting(boats));
        byType.put(ServerLinkHandler.RECONNECT, ServerLinkHandler.reconnecting(boats));
        byType.put(ResendWaypointsHandler.TYPE, new ResendWaypointsHandler(motion));
    }

    void addSubscriptions(AreaSubscriptions areas, MeasurementHandler measurements, BatterySubscriptions batteries) {
        byType.put(AreaSubscriptions.TYPE, areas);
        byType.put(MeasurementHandler.TYPE, measurements);
        byType.put(BatterySubscriptions.TYPE, batteries);
    }

    void addMissions(TaskQueues tasks) {
        byType.put(DisplayMessageHandler.TYPE, new DisplayMessageHandler(messages));
        byType.put(TaskCompleteHandler.TYPE, new TaskCompleteHandler());
        byType.put(RefreshTasksHandler.TYPE, new RefreshTasksHandler(tasks));
        byType.put(UnknownRequestHandler.TYPE, new UnknownRequestHandler(messages));
    }
}
