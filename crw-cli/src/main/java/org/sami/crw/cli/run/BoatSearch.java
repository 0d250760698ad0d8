package org.sami.crw.cli.run;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.sami.crw.cli.option.NetworkOption;
import org.sami.crw.proxy.near.BoatFinder;
import org.sami.crw.proxy.near.FoundBoats;
import org.sami.crw.proxy.near.NearBoat;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.crw.proxy.tcp.BoatAddress;

/** Looks for boats near, for commands. */
final class BoatSearch {
    /** How long commands look that connect to what they find, in ms: JmDNS asks again after 4 s at most. */
    static final long USUAL_MS = 8000;

    private BoatSearch() {}

    /** Looks for so long. */
    static FoundBoats look(NetworkOption network, long millis) throws InterruptedException {
        try (BoatFinder finder = network.open()) {
            Thread.sleep(millis);
            return finder.snapshot();
        }
    }

    /** Says what cannot be read, and where boats cannot be looked for. */
    static void tellProblems(FoundBoats found, PrintWriter err) {
        found.problems().forEach(problem -> err.println("crw: " + problem));
        found.unreadable().forEach(problem -> err.println("crw: " + problem));
        err.flush();
    }

    /**
     * The addresses of all that are found and can be connected; says what is left out, and why.
     *
     * @throws IOException if the keys of this base cannot be read
     */
    static List<BoatAddress> connectable(NetworkOption network, PrintWriter err)
            throws IOException, InterruptedException {
        FoundBoats found = look(network, USUAL_MS);
        tellProblems(found, err);
        List<BoatAddress> addresses = new ArrayList<>();
        for (NearBoat boat : NearBoat.of(found.boats(), BaseProtection.ofThisProcess(), Set.of())) {
            if (boat.state().canConnect()) {
                addresses.add(boat.found().address());
            } else {
                err.println(
                        "crw: --near leaves out " + boat.found().announcement().name() + " at "
                                + boat.found().address() + ": " + boat.stateWords());
            }
        }
        if (addresses.isEmpty()) {
            err.println("crw: --near finds no boat that can be connected");
        }
        err.flush();
        return addresses;
    }

    /** A line for each boat, in columns. */
    static List<String> table(List<NearBoat> near) {
        int names = 0;
        int addresses = 0;
        for (NearBoat boat : near) {
            names = Math.max(names, boat.found().announcement().name().length());
            addresses = Math.max(addresses, boat.found().address().toString().length());
        }
        String form = "%-" + names + "s  %-" + addresses + "s  %5s  %s%s";
        List<String> lines = new ArrayList<>();
        for (NearBoat boat : near) {
            String hull = boat.found().announcement().hull();
            lines.add(String.format(
                    form,
                    boat.found().announcement().name(),
                    boat.found().address(),
                    boat.batteryWords(),
                    boat.stateWords(),
                    hull.isEmpty() ? "" : ", " + hull));
        }
        return lines;
    }
}
