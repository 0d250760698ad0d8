package org.sami.crw.cli.analysis;

import java.util.List;
import java.util.stream.IntStream;
import org.sami.crw.cli.output.UsageFault;
import org.sami.petri.net.PetriNet;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.Abstraction;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.planspace.PlanStateWords;
import org.sami.spn.planspace.StateWords;
import org.sami.spn.vocabulary.Vocabulary;

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

    /**
     * The net of a plan.
     *
     * @throws UsageFault if it is too large, or the plan has no start
     */
    static DrawnNet of(Project project, Plan plan, Vocabulary vocabulary, int boats) {
        List<String> robots =
                IntStream.rangeClosed(1, boats).mapToObj(i -> "robot-" + i).toList();
        try {
            PlanNet net = PlanNet.of(new PlanNetRequest(project, vocabulary, plan.id(), robots));
            String team = boats == 1 ? "1 boat" : boats + " boats";
            return new DrawnNet(
                    net.net(),
                    plan.title() + ", " + team,
                    new PlanStateWords(net),
                    net.abstractions().stream().map(DrawnNet::remark).toList());
        } catch (PlanNetTooLargeException | IllegalArgumentException refused) {
            throw new UsageFault(plan.id() + ": " + refused.getMessage());
        }
    }

    private static String remark(Abstraction abstraction) {
        return (abstraction.where().isEmpty() ? "" : abstraction.where() + ": ") + abstraction.text();
    }
}
