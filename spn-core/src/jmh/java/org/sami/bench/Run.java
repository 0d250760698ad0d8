package org.sami.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;

/** A session of a ring plan that answers activations, robot by robot; all effects are built and kept for one step. */
final class Run {
    final Engine engine;
    final EngineState state;
    private final int robots;
    private final List<String> names = new ArrayList<>();
    private final List<Effect> effects = new ArrayList<>();
    /** The activation that each robot of each mission answers next; by mission, then robot; robot 0 where there are none. */
    private final Activation[][] open;

    private int turn;

    Run(Engine engine, int robots, int missions) {
        this.engine = engine;
        this.robots = robots;
        this.state = engine.newState();
        this.open = new Activation[missions][Math.max(1, robots)];
        for (int i = 0; i < robots; i++) {
            names.add("robot" + i);
            engine.step(state, 0, new Input.ProxyJoined(names.get(i)));
        }
        for (int m = 0; m < missions; m++) {
            step(new Input.StartMission("ring", "ring", Map.of()));
        }
    }

    /** One answer of the next robot of the next mission. */
    List<Effect> next() {
        Input input = answer();
        turn = (turn + 1) % (open.length * open[0].length);
        step(input);
        return effects;
    }

    /** What {@link #next} will take. */
    Input answer() {
        int mission = turn % open.length;
        int robot = turn / open.length % open[0].length;
        Activation asked = open[mission][robot];
        List<String> named = robots == 0 ? List.of() : List.of(names.get(robot));
        return new Input.Received(Occurrence.answer("Done", asked, named, List.of(), Map.of()));
    }

    private void step(Input input) {
        effects.clear();
        engine.step(state, 0, input, effects::add);
        for (Effect e : effects) {
            if (e instanceof Effect.Activated a) {
                keep(a.activation());
            }
        }
    }

    private void keep(Activation a) {
        Activation[] mine = open[(int) a.mission() - 1];
        if (robots == 0) {
            mine[0] = a;
            return;
        }
        for (Token token : a.tokens()) {
            if (token instanceof Token.Proxy p) {
                mine[Integer.parseInt(p.proxy().substring("robot".length()))] = a;
            }
        }
    }
}
