package org.sami.dreamm.query;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.context.NetOverlay;
import org.sami.dreamm.tryout.TryOutOverlay;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.picture.net.NetBadges;
import org.sami.picture.net.NetMarking;
import org.sami.spn.finding.Finding;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.planspace.BoundNotes;
import org.sami.spn.planspace.PlaceBound;
import org.sami.spn.planspace.PlanBounds;

/**
 * How many tokens can be in each place of the open plan, searched when it is asked for: a sign at each place of the net, in its tooltip and in the inspector why there are
 * no more, and notes among the issues. Forgotten where the plan runs otherwise. All on the owner's thread.
 */
public final class BoundsOfPlan {
    private static final SearchBudget BUDGET =
            new SearchBudget(1_000_000, Runtime.getRuntime().maxMemory() / 8, Duration.ofMinutes(1));

    private final DreammContext context;
    private final TryOutOverlay overlay;
    private final PlanSearch<PlanBounds> search;

    /**
     * Adds its command to a window's.
     *
     * @param robots names of the robots with which a plan is searched
     */
    public BoundsOfPlan(
            DreammContext context,
            TryOutOverlay overlay,
            Supplier<List<String>> robots,
            Executor worker,
            Executor owner) {
        this.context = Objects.requireNonNull(context, "context");
        this.overlay = Objects.requireNonNull(overlay, "overlay");
        search = new PlanSearch<>(
                context,
                robots,
                worker,
                owner,
                new PlanSearch.CommandWords(
                        "query-bounds", "Bounds of places on the net, or no more", "fit", "alt shift F9"),
                new Signs());
    }

    /** The bounds that are shown; empty while they are searched, or where nobody asks for them. */
    Optional<PlanBounds> bounds() {
        return search.result();
    }

    /** What was found, or that it is searched; empty text where bounds are not shown. */
    String words() {
        return search.words();
    }

    /** Notes about the plan whose bounds are shown. */
    public List<Finding> notes() {
        return bounds().flatMap(found -> context.document()
                        .project()
                        .plan(found.plan())
                        .map(plan -> BoundNotes.of(found, plan, context.vocabulary())))
                .orElse(List.of());
    }

    /** Tells somebody when something else is shown. */
    public void addListener(Runnable listener) {
        search.addListener(listener);
    }

    private final class Signs implements PlanSearch.Subject<PlanBounds> {
        @Override
        public String begun() {
            return "Searching for bounds…";
        }

        @Override
        public PlanBounds search(PlanNetRequest request, BooleanSupplier stop) throws PlanNetTooLargeException {
            return PlanBounds.of(request, BUDGET, new GraphWatch() {
                @Override
                public void looked(int states, int waiting) {
                    // most plans are searched in a moment
                }

                @Override
                public boolean isCancelled() {
                    return stop.getAsBoolean();
                }
            });
        }

        @Override
        public String found(PlanBounds found) {
            Map<String, String> signs = new LinkedHashMap<>();
            found.places().forEach(place -> signs.put(place.place(), place.sign()));
            overlay.showInstead(Optional.of(new NetOverlay.Shown(
                    NetMarking.EMPTY,
                    new NetBadges(Set.of(), Set.of(), signs),
                    id -> found.of(id).map(PlaceBound::words))));
            return found.summary();
        }

        @Override
        public String refused(String why) {
            return "no bounds: " + why;
        }

        @Override
        public void forgotten(boolean wasFound) {
            if (wasFound) {
                overlay.showInstead(Optional.empty());
            }
        }
    }
}
