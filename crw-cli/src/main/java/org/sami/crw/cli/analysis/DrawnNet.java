package org.sami.crw.cli.analysis;

import java.util.List;
import org.sami.petri.net.PetriNet;
import org.sami.spn.plannet.Abstraction;
import org.sami.spn.planspace.PlanStateWords;
import org.sami.spn.planspace.StateWords;

/**
 * A net whose graph is to be drawn.
 *
 * @param title of the picture
 * @param remarks where the net is not exactly the plan that it stands for
 */
record DrawnNet(PetriNet net, String title, StateWords words, List<String> remarks) {
    /** A net of a file or an example. */
    static DrawnNet of(PetriNet net, String name) {
        return new DrawnNet(net, net.name().isEmpty() ? name : net.name(), new NetStateWords(net), List.of());
    }

    /** The net of a plan. */
    static DrawnNet of(PlanArgument plan) {
        return new DrawnNet(
                plan.net().net(),
                plan.title(),
                new PlanStateWords(plan.net()),
                plan.net().abstractions().stream().map(Abstraction::words).toList());
    }
}
