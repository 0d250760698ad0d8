package org.sami.boat.server.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.link.Ack;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Hello;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Role;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.tcp.TcpBench.Client;

/** Bases that take a boat from each other, each on a socket of its own, and go on commanding until they are refused. */
@Timeout(900)
class TakeOversOverTcpTest {
    private static final int TAKE_OVERS = 10_000;
    private static final int MOST_COMMANDS = 20; // of one epoch, where nobody takes the boat

    /** A command of a base: its epoch, and its number among those of the epoch; 0 takes the boat. */
    private static final String ID = "%d-%d";

    private final AtomicLong epochs = new AtomicLong();
    private final AtomicInteger takenOver = new AtomicInteger();

    @Test
    void boatCarriesOutNothingOfASupersededBaseInTenThousandTakeOvers() throws Exception {
        ExecutorService threads = Executors.newFixedThreadPool(2);
        try (TcpBench bench = new TcpBench()) {
            List<Future<Integer>> bases = new ArrayList<>();
            for (String base : List.of("a", "b")) {
                bases.add(threads.submit(() -> rival(bench, base)));
            }
            int refused = 0;
            for (Future<Integer> base : bases) {
                refused += base.get();
            }

            assertThat(refused).as("commands of superseded bases").isGreaterThan(TAKE_OVERS / 10);
            long newest = 0;
            for (String done : bench.executed) {
                String[] idAndAnswer = done.split(" ");
                if (idAndAnswer[1].equals("ack")) {
                    long epoch = Long.parseLong(idAndAnswer[0].split("-")[0]);
                    assertThat(epoch)
                            .as("the epoch of %s after %d", done, newest)
                            .isGreaterThanOrEqualTo(newest);
                    newest = epoch;
                }
            }
            assertThat(newest).as("the last epoch that commanded").isGreaterThan(TAKE_OVERS * 9 / 10);
            assertThat(bench.failures).isEmpty();
        } finally {
            takenOver.set(TAKE_OVERS); // also where one of them failed
            threads.shutdownNow();
        }
    }

    /** Takes the boat whenever it is not its own; gives how many commands were refused because another had taken it. */
    private int rival(TcpBench bench, String base) throws Exception {
        int refused = 0;
        try (Client client = bench.connect()) {
            client.say(new Hello("boat1", base, Role.OBSERVER, 0.1, "", base + ".0", 0));
            client.await(Welcome.class);
            while (takenOver.get() < TAKE_OVERS) {
                long epoch = epochs.incrementAndGet();
                LinkMessage answer = answer(client, new TakeCommand(ID.formatted(epoch, 0), base + ".0", epoch));
                if (answer instanceof Ack) {
                    takenOver.incrementAndGet();
                }
                for (int i = 1; answer instanceof Ack && i <= MOST_COMMANDS; i++) {
                    answer = answer(client, new HoldPosition(ID.formatted(epoch, i)));
                }
                if (answer instanceof Nack no) {
                    assertThat(no.reason()).isIn(NackReason.SUPERSEDED, NackReason.NOT_COMMANDER);
                    refused++;
                }
            }
        }
        return refused;
    }

    private static LinkMessage answer(Client client, CommandMessage command) throws Exception {
        client.say(command);
        while (true) {
            LinkMessage heard = client.await(LinkMessage.class);
            if (heard instanceof Ack yes && yes.commandId().equals(command.commandId())) {
                return yes;
            }
            if (heard instanceof Nack no && no.commandId().equals(command.commandId())) {
                return no;
            }
        }
    }
}
