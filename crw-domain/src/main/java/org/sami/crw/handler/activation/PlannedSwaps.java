package org.sami.crw.handler.activation;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Ids;

/**
 * Whether plans provide for battery swaps on the way: they wait for a battery event, or give a person something to do (Operator Background Action),
 * in the plan itself, its sub-missions or its parents.
 */
public final class PlannedSwaps {
    private static final String BACKGROUND_ACTION = "OperatorBackgroundAction";
    private static final Set<String> NEWS = Set.of(EventNames.BATTERY_LOW, EventNames.BATTERY_CRITICAL);

    private PlannedSwaps() {}

    /** The field with which a plan says whether charges are to last for ways home. */
    public static final String KEEP_HOME = "keepHome";

    /** Whether charges are to last for the ways home of what an activation asks: unless its plan says otherwise, or has batteries swapped. */
    public static boolean keepWaysHome(Activation activation, HandlerContext context) {
        return ActivationFields.flag(activation, KEEP_HOME).orElse(true)
                && !context.query(view -> areOf(activation.mission(), view));
    }

    /** Whether the plans of a mission do. */
    public static boolean areOf(long mission, EngineView view) {
        Optional<MissionView> root = view.mission(mission);
        while (root.isPresent() && root.get().parent() != Ids.NONE) {
            root = view.mission(root.get().parent());
        }
        return root.flatMap(one -> view.planOf(one.id()))
                .filter(plan -> provides(plan, view, new HashSet<>()))
                .isPresent();
    }

    private static boolean provides(Plan plan, EngineView view, Set<String> seen) {
        return seen.add(plan.id())
                && (plan.transitions().stream()
                                .flatMap(transition -> transition.inputs().stream())
                                .anyMatch(input -> NEWS.contains(input.type()))
                        || plan.places().stream()
                                .anyMatch(place -> place.outputs().stream()
                                                .anyMatch(
                                                        output -> output.type().equals(BACKGROUND_ACTION))
                                        || place.subMissions().stream()
                                                .flatMap(run -> view.plan(run.plan()).stream())
                                                .anyMatch(run -> provides(run, view, seen))));
    }
}
