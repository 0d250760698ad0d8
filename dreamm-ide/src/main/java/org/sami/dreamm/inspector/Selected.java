package org.sami.dreamm.inspector;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.sami.picture.net.NetScene;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What is selected in a plan. A selected event or sub-mission stands for its vertex.
 *
 * @param events ids of the selected events and sub-missions
 */
record Selected(
        List<Place> places,
        List<Transition> transitions,
        List<InEdge> inEdges,
        List<OutEdge> outEdges,
        Set<Integer> frames,
        Set<String> events) {
    Selected {
        places = List.copyOf(places);
        transitions = List.copyOf(transitions);
        inEdges = List.copyOf(inEdges);
        outEdges = List.copyOf(outEdges);
        frames = Set.copyOf(frames);
        events = Set.copyOf(events);
    }

    static Selected of(Plan plan, Set<String> ids) {
        Set<String> events = new LinkedHashSet<>(ids);
        return new Selected(
                plan.places().stream()
                        .filter(p -> ids.contains(p.id())
                                || p.outputs().stream().anyMatch(o -> ids.contains(o.id()))
                                || p.subMissions().stream().anyMatch(s -> ids.contains(s.id())))
                        .toList(),
                plan.transitions().stream()
                        .filter(t -> ids.contains(t.id()) || t.inputs().stream().anyMatch(i -> ids.contains(i.id())))
                        .toList(),
                plan.inEdges().stream().filter(e -> ids.contains(e.id())).toList(),
                plan.outEdges().stream().filter(e -> ids.contains(e.id())).toList(),
                frames(plan, ids),
                events);
    }

    private static Set<Integer> frames(Plan plan, Set<String> ids) {
        Set<Integer> frames = new LinkedHashSet<>();
        for (int i = 0; i < plan.frames().size(); i++) {
            if (ids.contains(NetScene.idOfFrame(i))) {
                frames.add(i);
            }
        }
        return frames;
    }

    int vertices() {
        return places.size() + transitions.size();
    }

    int edges() {
        return inEdges.size() + outEdges.size();
    }

    boolean isEmpty() {
        return vertices() + edges() + frames.size() == 0;
    }

    /** Ids of the vertices and edges. */
    Set<String> elements() {
        Set<String> ids = new LinkedHashSet<>(edgeIds());
        places.forEach(p -> ids.add(p.id()));
        transitions.forEach(t -> ids.add(t.id()));
        return ids;
    }

    /** Those of some findings that are about what is selected, or about an event or a sub-mission of it. */
    List<Finding> findings(Plan plan, List<Finding> all) {
        Set<String> ids = elements();
        places.forEach(p -> {
            p.outputs().forEach(o -> ids.add(o.id()));
            p.subMissions().forEach(s -> ids.add(s.id()));
        });
        transitions.forEach(t -> t.inputs().forEach(i -> ids.add(i.id())));
        return all.stream()
                .filter(f -> f.plan().equals(plan.id()))
                .filter(f -> f.elements().stream().anyMatch(ids::contains))
                .toList();
    }

    Set<String> edgeIds() {
        Set<String> ids = new LinkedHashSet<>();
        inEdges.forEach(e -> ids.add(e.id()));
        outEdges.forEach(e -> ids.add(e.id()));
        return ids;
    }

    /** A title in words. */
    String title(Plan plan, Vocabulary vocabulary) {
        ElementNames names = new ElementNames(plan, vocabulary);
        if (vertices() + edges() == 0 && frames.size() == 1) {
            String title = plan.frames().get(frames.iterator().next()).title();
            return title.isBlank() ? "Frame" : "Frame " + title;
        }
        if (vertices() + edges() == 0) {
            return count(frames.size(), "frame", "frames");
        }
        if (vertices() == 1 && edges() == 0) {
            return places.isEmpty()
                    ? ElementNames.called(transitions.get(0), vocabulary)
                            .map(name -> "Transition " + name)
                            .orElseGet(() -> capital(names.of(transitions.get(0))))
                    : ElementNames.called(places.get(0), vocabulary)
                            .map(name -> "Place " + name)
                            .orElseGet(() -> capital(names.of(places.get(0))));
        }
        if (vertices() == 0 && edges() == 1) {
            return names.of(edgeIds().iterator().next()).orElse("Edge");
        }
        return (vertices() > 0 ? count(vertices(), "vertex", "vertices") : "")
                + (vertices() > 0 && edges() > 0 ? ", " : "")
                + (edges() > 0 ? count(edges(), "edge", "edges") : "");
    }

    private static String capital(String words) {
        return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }

    private static String count(int n, String one, String many) {
        return n + " " + (n == 1 ? one : many);
    }
}
