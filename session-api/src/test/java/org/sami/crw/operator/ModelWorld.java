package org.sami.crw.operator;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicLong;
import org.sami.crw.fleet.publishing.FleetEvents;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.spn.engine.Engine;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.EngineHostBuilder;
import org.sami.spn.host.HostClock;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.VocabularyReader;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Input;
import org.sami.spn.vocabulary.Vocabulary;

/** A real engine and real proxies that feed models whose owner works when the test says so. */
final class ModelWorld implements HostClock {
    static final Vocabulary VOCABULARY =
            VocabularyReader.fromClassPath("/org/sami/domain/crw").orThrow();

    /** Boats go from start to work by a press, and back by another or by the answer to a question; then all end. */
    private static final String PLAN = """
        {"formatVersion": 1, "id": "p", "name": "P", "domain": "crw", "plans": [{
          "id": "p", "name": "There and back",
          "variables": [{"name": "@note", "type": "text", "initial": "none"}],
          "tasks": [{"name": "a", "class": "Temperature"}, {"name": "b", "class": "Temperature"}],
          "places": [{"id": "start", "name": "Start", "start": true},
            {"id": "work", "name": "Work", "outputs": [{"id": "ask", "type": "OperatorSelectBoatList"}]},
            {"id": "end", "end": true}],
          "transitions": [
            {"id": "go", "inputs": [{"id": "i1", "type": "OperatorInterruptReceived", "fields": {"interruptName": "Go"}}]},
            {"id": "back", "inputs": [{"id": "i2", "type": "OperatorInterruptReceived", "fields": {"interruptName": "Back"}}]},
            {"id": "picked", "inputs": [{"id": "i3", "type": "OperatorSelectsBoatList"}]},
            {"id": "over", "inputs": [{"id": "i4", "type": "OperatorInterruptReceived", "fields": {"interruptName": "Over"}}]}],
          "inEdges": [
            {"id": "e1", "place": "start", "transition": "go", "requirements": [{"match": "at-least", "n": 1, "kind": "any-proxy"}]},
            {"id": "e2", "place": "work", "transition": "back", "requirements": [{"match": "at-least", "n": 1, "kind": "any-proxy"}]},
            {"id": "e3", "place": "work", "transition": "picked", "requirements": [{"match": "at-least", "n": 2, "kind": "any-proxy"}]},
            {"id": "e4", "place": "start", "transition": "over", "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]}],
          "outEdges": [
            {"id": "o1", "transition": "go", "place": "work", "requirements": [{"action": "take", "n": 1, "kind": "any-proxy"}]},
            {"id": "o2", "transition": "back", "place": "start", "requirements": [{"action": "take", "n": 1, "kind": "any-proxy"}]},
            {"id": "o3", "transition": "picked", "place": "start", "requirements": [{"action": "take", "n": 1, "kind": "any-proxy"}]},
            {"id": "o4", "transition": "over", "place": "end", "requirements": [{"action": "take", "n": "all", "kind": "any-token"}]}]}]}
        """;

    final Project project;
    final Queue<Runnable> engineWork = new ConcurrentLinkedQueue<>();
    final ArrayDeque<Runnable> ownerWork = new ArrayDeque<>();
    final AtomicLong nowMillis = new AtomicLong();
    final ProxyRegistry boats = new ProxyRegistry();
    final FleetEvents events = new FleetEvents();
    final OperatorModels models;
    final EngineHost host;

    /** The models work when the test has them do so, and the engine when it is stepped. */
    ModelWorld() {
        this(PLAN);
    }

    /** The same with other plans. */
    ModelWorld(String document) {
        project = new ProjectReader(VOCABULARY).read(document).orThrow();
        models = new OperatorModels(ownerWork::add, nowMillis::get);
        host = host(engineWork::add);
    }

    /** A world with an owner and an engine on threads of their own. */
    ModelWorld(Executor owner, Executor engine) {
        project = new ProjectReader(VOCABULARY).read(PLAN).orThrow();
        models = new OperatorModels(owner, nowMillis::get);
        host = host(engine);
    }

    private EngineHost host(Executor executor) {
        Engine engine = new Engine(VOCABULARY, project);
        EngineHost made = EngineHostBuilder.of(engine, engine.newState())
                .clock(this)
                .executor(executor)
                .build();
        made.addListener(models);
        events.subscribe(models.fleetListener(boats));
        return made;
    }

    BoatProxy boat(String id) {
        BoatProxy proxy = new BoatProxy(id, frame -> {}, events::publish, ProxyConfig.DEFAULT);
        boats.add(proxy);
        events.onBoat(proxy);
        return proxy;
    }

    static Input start(String name) {
        return new Input.StartMission("p", name, Map.of());
    }

    /** Posts inputs and has the engine take them; the models hear of it and do nothing yet. */
    void step(Input... inputs) {
        for (Input input : inputs) {
            host.post(List.of(input));
        }
        for (Runnable work = engineWork.poll(); work != null; work = engineWork.poll()) {
            work.run();
        }
    }

    /** Has the models' owner work. */
    void settle() {
        for (Runnable work = ownerWork.poll(); work != null; work = ownerWork.poll()) {
            work.run();
        }
    }

    /** Has the engine asked what effects do not tell. */
    void refresh() {
        models.refresh(host, VOCABULARY);
        step();
        settle();
    }

    @Override
    public long nowMillis() {
        return nowMillis.get();
    }

    @Override
    public void wakeAt(long millis, Runnable action) {
        // no plan here has timers
    }
}
