package org.sami.crw.cli.run;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import org.sami.boat.link.BoatAnnouncement;
import org.sami.crw.cli.option.LinkOptions;
import org.sami.crw.cli.option.NetworkOption;
import org.sami.crw.cli.option.SecondsConverter;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.proxy.near.FoundBoats;
import org.sami.crw.proxy.near.NearBoat;
import org.sami.crw.proxy.tcp.BaseProtection;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw find}: the boats that announce themselves on the local network. */
@Command(
        name = "find",
        mixinStandardHelpOptions = true,
        description =
                "Lists the boats that announce themselves on the local network: name, address, charge, and whether "
                        + "this base can connect to them.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:boats were found", "2:wrong usage", "4:none was found, or this base's keys cannot be read"},
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw find",
            "  crw find --within 20 --json",
            "  crw session --near             connects to all that are found and paired"
        })
public final class FindCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private LinkOptions links = new LinkOptions();

    @Mixin
    private NetworkOption network = new NetworkOption();

    @Option(
            names = "--within",
            paramLabel = "SECONDS",
            defaultValue = "8",
            converter = SecondsConverter.class,
            description = "How long to look for boats (default ${DEFAULT-VALUE}).")
    private long withinMillis;

    @Option(names = "--json", description = "Print one JSON object.")
    private boolean json;

    @Override
    public Integer call() throws IOException, InterruptedException {
        links.use();
        FoundBoats found = BoatSearch.look(network, withinMillis);
        List<NearBoat> near = NearBoat.of(found.boats(), BaseProtection.ofThisProcess(), Set.of());
        BoatSearch.tellProblems(found, spec.commandLine().getErr());
        PrintWriter out = spec.commandLine().getOut();
        if (json) {
            out.println(object(near).toPrettyString());
        } else if (near.isEmpty()) {
            out.println("no boat announces itself on the networks of this machine; connect boats by their addresses");
        } else {
            BoatSearch.table(near).forEach(out::println);
        }
        out.flush();
        return near.isEmpty() ? ExitCode.FAILED : ExitCode.OK;
    }

    private static ObjectNode object(List<NearBoat> near) {
        ObjectNode object = JsonNodeFactory.instance.objectNode();
        ArrayNode boats = object.putArray("boats");
        for (NearBoat boat : near) {
            BoatAnnouncement announced = boat.found().announcement();
            ObjectNode one = boats.addObject();
            one.put("boat", announced.boatId()).put("name", announced.name());
            one.put("address", boat.found().address().toString());
            announced.batteryPercent().ifPresent(percent -> one.put("battery", percent));
            one.put("state", boat.stateWords()).put("connectable", boat.state().canConnect());
            one.put("hull", announced.hull()).put("key", announced.key()).put("link", announced.linkVersion());
        }
        return object;
    }
}
