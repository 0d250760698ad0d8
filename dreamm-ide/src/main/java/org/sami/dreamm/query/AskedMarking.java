package org.sami.dreamm.query;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.StartMarking;

/** The question whether tokens can stand together in some places: as they were put there for a start, or a robot in each place that is selected. */
final class AskedMarking {
    private AskedMarking() {}

    /**
     * The query; empty where nothing is marked and no place is selected.
     *
     * @param marked where tokens were put
     * @param selected ids of elements; only places count, and only where nothing is marked
     */
    static Optional<PlanQuery> of(Plan plan, Optional<StartMarking> marked, Set<String> selected) {
        List<String> words = new ArrayList<>();
        List<String> conditions = new ArrayList<>();
        marked.map(StartMarking::places).orElse(List.of()).forEach(tokens -> {
            Optional<Place> place = plan.place(tokens.place());
            place.ifPresent(at -> add(at, tokens, words, conditions));
        });
        if (conditions.isEmpty()) {
            plan.places().stream()
                    .filter(place -> selected.contains(place.id()))
                    .forEach(place -> {
                        words.add("a robot in " + title(place));
                        conditions.add(atLeast(place, "robots", 1));
                    });
        }
        return conditions.isEmpty()
                ? Optional.empty()
                : Optional.of(new PlanQuery(
                        String.join(", ", words),
                        "reachable " + String.join(" and ", conditions),
                        PlanQuery.Expected.YES));
    }

    private static void add(Place place, StartMarking.Tokens tokens, List<String> words, List<String> conditions) {
        int robots = tokens.proxies().size();
        List<String> here = new ArrayList<>();
        if (robots > 0) {
            here.add(robots == 1 ? "a robot" : robots + " robots");
            conditions.add(atLeast(place, "robots", robots));
        }
        if (tokens.generic() > 0) {
            here.add(tokens.generic() + " generic");
            conditions.add(atLeast(place, "generic", tokens.generic()));
        }
        for (String task : tokens.tasks()) {
            here.add(task);
            conditions.add(atLeast(place, task, 1));
        }
        words.add(String.join(" and ", here) + " in " + title(place));
    }

    private static String atLeast(Place place, String kind, int count) {
        return "m(" + word(place.id()) + "." + word(kind) + ") >= " + count;
    }

    private static String word(String name) {
        return name.matches("[\\p{L}\\p{N}_:-]+") ? name : "\"" + name + "\"";
    }

    private static String title(Place place) {
        return place.name().isBlank() ? place.id() : place.name();
    }
}
