package org.sami.spn.json;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;

/**
 * The texts from which one reading came, to say of its findings in which file, line and column they lie. A finding belongs to the
 * text by whose prefix its pointer begins: none for the document itself, {@code FILE#} for the others.
 */
final class SourceTexts {
    private static final String PLANS = "/plans/";

    private final Map<String, Source> sources = new LinkedHashMap<>();
    private final Map<String, String> planPrefixes = new LinkedHashMap<>();
    private final Map<String, String> planIds = new LinkedHashMap<>();

    /** Keeps a text; the prefix of its findings is empty for the document that was asked for. */
    void add(String prefix, String file, String text) {
        sources.put(prefix, new Source(file, JsonText.withoutMark(text)));
    }

    /** The plan of an index in the project stands in the text of a prefix: pointers of checks speak of the index. */
    void planIn(int index, String prefix) {
        planPrefixes.put(PLANS + index, prefix);
    }

    /** The plan whose object stands at a pointer has an id: findings below it are about that plan. */
    void planNamed(String pointer, String id) {
        planIds.put(pointer, id);
    }

    private Finding withPlan(Finding f) {
        if (!f.plan().isEmpty()) {
            return f;
        }
        return planIds.entrySet().stream()
                .filter(e -> f.pointer().equals(e.getKey()) || f.pointer().startsWith(e.getKey() + "/"))
                .findFirst()
                .map(e -> f.inPlan(e.getValue()))
                .orElse(f);
    }

    /** The findings with their places in files and, where they name none, the element around that place. */
    List<Finding> locate(List<Finding> findings) {
        Map<String, List<String>> wanted = new LinkedHashMap<>();
        for (Finding f : findings) {
            Spot spot = spot(f.pointer());
            wanted.computeIfAbsent(spot.prefix, p -> new ArrayList<>()).add(spot.pointer);
        }
        Map<String, Map<String, JsonPlaces.Place>> places = new LinkedHashMap<>();
        wanted.forEach((prefix, pointers) -> {
            Source source = sources.get(prefix);
            places.put(prefix, source == null ? Map.of() : JsonPlaces.find(source.text, pointers));
        });
        return findings.stream().map(f -> located(withPlan(f), places)).toList();
    }

    private Finding located(Finding f, Map<String, Map<String, JsonPlaces.Place>> places) {
        Spot spot = spot(f.pointer());
        Optional<Source> source = Optional.ofNullable(sources.get(spot.prefix));
        if (f.location().isPresent()) { // by the parser, which knows no file
            SourceLocation known = f.location().get();
            return known.file().isEmpty() && source.isPresent()
                    ? f.at(new SourceLocation(source.get().file, known.line(), known.column()))
                    : f;
        }
        JsonPlaces.Place place = places.getOrDefault(spot.prefix, Map.of()).get(spot.pointer);
        if (place == null) {
            return f;
        }
        Finding found = f.at(new SourceLocation(source.orElseThrow().file, place.line(), place.column()));
        return f.elements().isEmpty()
                ? place.element().map(List::of).map(found::about).orElse(found)
                : found;
    }

    private Spot spot(String pointer) {
        int hash = pointer.indexOf('#');
        if (hash >= 0 && sources.containsKey(pointer.substring(0, hash + 1))) {
            return new Spot(pointer.substring(0, hash + 1), pointer.substring(hash + 1));
        }
        if (pointer.startsWith(PLANS)) {
            int end = pointer.indexOf('/', PLANS.length());
            String plan = end < 0 ? pointer : pointer.substring(0, end);
            if (planPrefixes.containsKey(plan)) {
                return new Spot(planPrefixes.get(plan), pointer.substring(plan.length()));
            }
        }
        return new Spot("", pointer.startsWith("/") ? pointer : "");
    }

    private record Source(String file, String text) {}

    /** A place in one of the texts. */
    private record Spot(String prefix, String pointer) {}
}
