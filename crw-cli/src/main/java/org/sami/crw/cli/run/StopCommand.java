package org.sami.crw.cli.run;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.PrintWriter;
import java.util.List;
import java.util.concurrent.Callable;
import org.sami.crw.cli.option.BoatAddresses;
import org.sami.crw.cli.option.LinkOptions;
import org.sami.crw.cli.option.SecondsConverter;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.sim.tcp.FleetOrder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code crw stop}: the fleet stop, from anywhere. */
@Command(
        name = "stop",
        mixinStandardHelpOptions = true,
        description =
                "Stops the boats at these addresses, even if another base commands them: motors to zero, latched until"
                        + " it is released, also over lost links and restarts. Prints the answer of each boat.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:every boat obeyed",
            "2:wrong usage, or the release was not confirmed",
            "4:a boat did not answer: it may be moving"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw stop 127.0.0.1:5001 127.0.0.1:5002",
            "  crw stop --release 127.0.0.1:5001             first step: lists the boats to release",
            "  crw stop --release --confirm 127.0.0.1:5001   second step: releases them"
        })
public final class StopCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private LinkOptions links = new LinkOptions();

    @Mixin
    private BoatAddresses boats = new BoatAddresses();

    @Option(names = "--release", description = "End a fleet stop instead; nothing is released without --confirm.")
    private boolean release;

    @Option(names = "--confirm", description = "With --release: do it.")
    private boolean confirm;

    @Option(
            names = "--within",
            paramLabel = "SECONDS",
            defaultValue = "5",
            converter = SecondsConverter.class,
            description = "How long a boat may take to answer (default ${DEFAULT-VALUE}).")
    private long withinMillis;

    @Option(names = "--json", description = "Print one JSON object.")
    private boolean json;

    @Override
    public Integer call() throws InterruptedException {
        links.use();
        if (confirm && !release) {
            throw new ParameterException(spec.commandLine(), "--confirm goes with --release; a stop needs none");
        }
        FleetOrder.Kind kind =
                !release ? FleetOrder.Kind.STOP : confirm ? FleetOrder.Kind.RELEASE : FleetOrder.Kind.LOOK;
        List<FleetOrder.Answer> answers = FleetOrder.give(kind, boats.addresses(), withinMillis);
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(object(answers).toPrettyString());
        } else {
            answers.forEach(
                    a -> out.printf("%s  %s%s%n", a.address(), a.boat().isEmpty() ? "" : a.boat() + ": ", a.words()));
        }
        out.flush();
        if (kind == FleetOrder.Kind.LOOK) {
            return unconfirmed(answers);
        }
        return answers.stream().allMatch(FleetOrder.Answer::done) ? ExitCode.OK : ExitCode.FAILED;
    }

    private int unconfirmed(List<FleetOrder.Answer> answers) {
        long stopped = answers.stream().filter(FleetOrder.Answer::stopped).count();
        PrintWriter err = spec.commandLine().getErr();
        err.println("crw: nothing was released; " + stopped + (stopped == 1 ? " boat is" : " boats are")
                + " stopped. Add --confirm to release all boats at these addresses.");
        err.flush();
        return ExitCode.USAGE;
    }

    private static ObjectNode object(List<FleetOrder.Answer> answers) {
        ObjectNode object = JsonNodeFactory.instance.objectNode();
        ArrayNode boats = object.putArray("boats");
        for (FleetOrder.Answer answer : answers) {
            ObjectNode node = boats.addObject();
            node.put("address", answer.address().toString());
            node.put("boat", answer.boat());
            node.put("done", answer.done());
            node.put("stopped", answer.stopped());
            node.put("answer", answer.words());
        }
        return object;
    }
}
