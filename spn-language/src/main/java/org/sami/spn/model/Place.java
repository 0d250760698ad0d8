package org.sami.spn.model;

import java.util.List;
import java.util.Objects;

/**
 * A place.
 *
 * @param name for people; may be empty
 * @param endsSharedInstance on an end place of a static sub-mission: entering it ends the shared instance; otherwise it
 *     returns
 * @param transitionOrder ids of out-transitions in the order in which they are looked at; those not listed follow in the
 *     order of the plan's in edges
 * @param disabled whether its events are not sent and its sub-missions not started while the plan is tried
 */
public record Place(
        String id,
        String name,
        boolean start,
        boolean end,
        boolean endsSharedInstance,
        Mode mode,
        List<OutputEventSpec> outputs,
        List<SubMissionSpec> subMissions,
        List<String> transitionOrder,
        boolean disabled) {
    public Place {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(mode, "mode");
        outputs = List.copyOf(outputs);
        subMissions = List.copyOf(subMissions);
        transitionOrder = List.copyOf(transitionOrder);
    }

    /** A place that is not disabled. */
    public Place(
            String id,
            String name,
            boolean start,
            boolean end,
            boolean endsSharedInstance,
            Mode mode,
            List<OutputEventSpec> outputs,
            List<SubMissionSpec> subMissions,
            List<String> transitionOrder) {
        this(id, name, start, end, endsSharedInstance, mode, outputs, subMissions, transitionOrder, false);
    }

    /** The same place with another id. */
    public Place withId(String id) {
        return new Place(
                id, name, start, end, endsSharedInstance, mode, outputs, subMissions, transitionOrder, disabled);
    }

    /** The same place with another name. */
    public Place withName(String name) {
        return new Place(
                id, name, start, end, endsSharedInstance, mode, outputs, subMissions, transitionOrder, disabled);
    }

    /** The same place with another value of {@code start}. */
    public Place withStart(boolean start) {
        return new Place(
                id, name, start, end, endsSharedInstance, mode, outputs, subMissions, transitionOrder, disabled);
    }

    /** The same place with another value of {@code end}. */
    public Place withEnd(boolean end) {
        return new Place(
                id, name, start, end, endsSharedInstance, mode, outputs, subMissions, transitionOrder, disabled);
    }

    /** The same place with another value of {@code endsSharedInstance}. */
    public Place withEndsSharedInstance(boolean endsSharedInstance) {
        return new Place(
                id, name, start, end, endsSharedInstance, mode, outputs, subMissions, transitionOrder, disabled);
    }

    /** The same place with another mode. */
    public Place withMode(Mode mode) {
        return new Place(
                id, name, start, end, endsSharedInstance, mode, outputs, subMissions, transitionOrder, disabled);
    }

    /** The same place with other outputs. */
    public Place withOutputs(List<OutputEventSpec> outputs) {
        return new Place(
                id, name, start, end, endsSharedInstance, mode, outputs, subMissions, transitionOrder, disabled);
    }

    /** The same place with other sub missions. */
    public Place withSubMissions(List<SubMissionSpec> subMissions) {
        return new Place(
                id, name, start, end, endsSharedInstance, mode, outputs, subMissions, transitionOrder, disabled);
    }

    /** The same place with another order of its out-transitions. */
    public Place withTransitionOrder(List<String> transitionOrder) {
        return new Place(
                id, name, start, end, endsSharedInstance, mode, outputs, subMissions, transitionOrder, disabled);
    }

    /** The same place with another value of {@code disabled}. */
    public Place withDisabled(boolean disabled) {
        return new Place(
                id, name, start, end, endsSharedInstance, mode, outputs, subMissions, transitionOrder, disabled);
    }
}
