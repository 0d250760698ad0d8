package org.sami.crw.handler.planning;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.activation.PlanAreas;
import org.sami.crw.handler.activation.Restrictions;
import org.sami.crw.handler.motion.BoatErrors;
import org.sami.crw.message.MessageSink;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.service.coverage.AreaCoverage;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;

/**
 * Measures the part of explored areas that boats cover, by their reported positions, and notifies the operator when the last share is driven, or at
 * an earlier end of the mission. For the fleet's thread; it passes the engine's steps on to it.
 */
public final class ExploredAreas implements Consumer<FleetEvent>, HostListener {
    private final MessageSink messages;
    private final Computations computations;
    private final BoatErrors errors;
    private final Executor fleet;
    private final Map<String, ExploredArea> areas = new LinkedHashMap<>(); // by mission and area

    public ExploredAreas(MessageSink messages, Computations computations, BoatErrors errors, Executor fleet) {
        this.messages = messages;
        this.computations = computations;
        this.errors = errors;
        this.fleet = fleet;
    }

    /**
     * Boats of a mission explore an area, from now on or again.
     *
     * @param name names mission and area
     * @param shares the paths of all boats that have one
     * @param uncoveredM2 what of the area they leave; empty where it was not computed with them
     */
    void explore(
            String name,
            Activation activation,
            HandlerContext context,
            GeoArea area,
            double spacingM,
            Map<String, GeoPath> shares,
            OptionalDouble uncoveredM2) {
        ExploredArea one = areas.get(name);
        if (one == null) {
            AreaCoverage coverage = AreaCoverage.of(
                    area,
                    spacingM,
                    context.query(view -> PlanAreas.avoided(activation, view)),
                    Restrictions.within(activation));
            areas.put(name, new ExploredArea(activation, context, coverage, spacingM, shares, uncoveredM2));
        } else {
            one.divide(shares);
        }
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.StatusReported reported) {
            onStatus(reported.status());
        } else if (event instanceof FleetEvent.CommandCompleted done) {
            onCompleted(done.boat(), done.command());
        }
    }

    private void onStatus(BoatStatus status) {
        status.pose()
                .map(BoatPose::position)
                .ifPresent(at -> areas.values().forEach(one -> one.add(status.boatId(), at)));
    }

    private void onCompleted(String boat, BoatCommand command) {
        if (command instanceof FollowPath path) {
            for (ExploredArea one : areas.values()) {
                if (one.complete(boat, path)) {
                    tell(one, "");
                }
            }
        }
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.MissionEnded ended) {
                fleet.execute(() -> forget(ended.mission()));
            }
        }
    }

    private void forget(long mission) {
        areas.values().stream()
                .filter(one -> one.mission() == mission && one.hasTracks())
                .forEach(one -> tell(one, " until the mission ended"));
        areas.values().removeIf(one -> one.mission() == mission);
    }

    private void tell(ExploredArea one, String when) {
        List<String> boats = one.boats();
        one.end(when, errors.of(boats).positionM())
                .ifPresent(result -> computations.aside(
                        result,
                        words -> messages.tell(new OperatorMessage(
                                one.nowMillis(),
                                one.mission(),
                                OperatorMessage.Source.DOMAIN,
                                Priority.MEDIUM,
                                words,
                                boats,
                                ""))));
    }
}
