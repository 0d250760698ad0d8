package org.sami.dreamm.tryout;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.sami.picture.net.NetMarking;
import org.sami.spn.model.Plan;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TestStart;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * A start marking that an author puts together for one plan, place by place, with what the plan asks at its start. On the document's thread.
 */
public final class StartMarkingSetup {
    private final Map<String, StartMarking.Tokens> places = new LinkedHashMap<>();
    private final Map<String, Value> values = new LinkedHashMap<>();
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private String plan = "";

    /** Begins again where another plan is meant. */
    public void of(String planId) {
        if (!plan.equals(planId)) {
            plan = planId;
            places.clear();
            values.clear();
            tell();
        }
    }

    /** What stands in a place; nothing and nobody where nothing was put there. */
    public StartMarking.Tokens at(String place) {
        return places.getOrDefault(place, new StartMarking.Tokens(place, 0, List.of(), List.of()));
    }

    /** Puts tokens into a place instead of those before; none empties it. */
    public void put(StartMarking.Tokens tokens) {
        if (tokens.generic() == 0
                && tokens.proxies().isEmpty()
                && tokens.tasks().isEmpty()) {
            places.remove(tokens.place());
        } else {
            places.put(tokens.place(), tokens);
        }
        tell();
    }

    /** What was given for something that the plan asks at its start; empty where its default holds. */
    public Optional<Value> given(String key) {
        return Optional.ofNullable(values.get(key));
    }

    /** All that was given for what the plan asks at its start. */
    public Map<String, Value> given() {
        return Map.copyOf(values);
    }

    /** Gives a value for something that the plan asks at its start. */
    public void give(String key, Value value) {
        values.put(key, value);
        tell();
    }

    /** Empties all places, and takes back what was given. */
    public void clear() {
        places.clear();
        values.clear();
        tell();
    }

    /** The start; empty while nothing stands anywhere. What the plan asks at its start and was not given has its default. */
    public Optional<TestStart> start() {
        return places.isEmpty()
                ? Optional.empty()
                : Optional.of(new TestStart(new StartMarking(List.copyOf(places.values())), values));
    }

    /** What a plan asks at its start that has no default and was not given; empty where nothing is missing. */
    public Optional<String> missing(Plan asking, Vocabulary vocabulary) {
        return AskedAtStart.of(asking, vocabulary).stream()
                .filter(asked -> asked.defaultValue().isEmpty() && !values.containsKey(asked.key()))
                .map(AskedAtStart::key)
                .findFirst();
    }

    /** Forgets places, tasks and values that a plan has no longer. */
    public void keep(Plan now, Vocabulary vocabulary) {
        Set<String> tasks = new LinkedHashSet<>();
        now.tasks().forEach(task -> tasks.add(task.name()));
        boolean gone = places.keySet().removeIf(place -> now.place(place).isEmpty());
        for (StartMarking.Tokens at : List.copyOf(places.values())) {
            List<String> left = at.tasks().stream().filter(tasks::contains).toList();
            gone |= left.size() != at.tasks().size();
            places.put(at.place(), new StartMarking.Tokens(at.place(), at.generic(), at.proxies(), left));
        }
        Map<String, AskedAtStart> asked = new LinkedHashMap<>();
        AskedAtStart.of(now, vocabulary).forEach(each -> asked.put(each.key(), each));
        gone |= values.entrySet()
                .removeIf(given -> !asked.containsKey(given.getKey())
                        || !TypeCheck.accepts(
                                asked.get(given.getKey()).field().type(), given.getValue(), vocabulary.types()));
        if (gone) {
            tell();
        }
    }

    /** How it looks on the net. */
    NetMarking marking() {
        Map<String, List<Token>> tokens = new LinkedHashMap<>();
        places.forEach((place, at) -> {
            List<Token> there = new ArrayList<>(Collections.nCopies(at.generic(), Token.GENERIC));
            at.proxies().forEach(robot -> there.add(new Token.Proxy(robot)));
            at.tasks().forEach(task -> there.add(new Token.Task(new TaskId(1, task))));
            tokens.put(place, there);
        });
        return new NetMarking(tokens, Set.of(), Map.of());
    }

    /** Tells somebody when something has changed. */
    public void addListener(Runnable listener) {
        listeners.add(listener);
    }

    private void tell() {
        listeners.forEach(Runnable::run);
    }
}
