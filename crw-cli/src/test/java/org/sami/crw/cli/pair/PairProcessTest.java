package org.sami.crw.cli.pair;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.cli.pair.PairedProcesses.await;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.CrwProcess;
import org.sami.session.client.testing.TwoNetworks;

/** Two bases as their operators run them: {@code crw pair} and {@code crw serve --pair}, with real databases of an installed PostgreSQL. */
@Tag("process")
@Timeout(600)
class PairProcessTest {
    private static final String SERVES = "the session is at ";
    private static final String READY = "this base goes on with it by itself";
    private static final String PROTECTED = "pair: protected";

    /** A mission of a simulated boat, which takes several times as long as a lease. */
    private static final List<String> MISSION = List.of(
            "add boat 45.4,10.9 1",
            "wait boats 1 within 60",
            "start clv",
            "wait decision within 60",
            "answer all",
            "wait decision within 60",
            "answer 45.4001,10.9001",
            "wait decision within 60",
            "answer 1",
            "wait ended within 300");

    @TempDir
    private Path folder;

    @Test
    void theSecondBaseGoesOnWhenTheFirstLosesItsPowerAndTheFirstComesBackAsItsStandby() throws Exception {
        try (PairedProcesses pair = PairedProcesses.onLoopback(folder)) {
            try (CrwProcess first = pair.serve(0);
                    CrwProcess second = pair.serve(1)) {
                await(first, SERVES);
                await(first, PROTECTED);
                await(second, READY);

                first.kill();
                pair.cutPower(0);

                await(second, SERVES);
                try (CrwProcess refused = pair.serve(0)) {
                    assertThat(refused.await(120)).isEqualTo(4);
                    assertThat(refused.err())
                            .contains(pair.address(1) + " took the session over")
                            .contains("crw pair rejoin");
                }
                assertThat(pair.run(0, "pair", "rejoin")).contains("the database that it had is kept in ");
                try (CrwProcess again = pair.serve(0)) {
                    await(again, READY);
                    await(second, PROTECTED);

                    assertThat(pair.run(0, "take-over")).contains("the base that stands by goes on with it");

                    await(again, SERVES);
                    assertThat(second.await(120)).isEqualTo(4);
                }
            }
        }
    }

    /** The second's clock is ahead of that of the first, with which it stands by; later that of the first is behind. */
    @Test
    void basesStandByAndGoOnAlsoWithClocksThatAreADayApart() throws Exception {
        try (PairedProcesses pair = PairedProcesses.onLoopback(folder, OtherClock.off("+1d"))) {
            try (CrwProcess first = pair.serve(0, MISSION);
                    CrwProcess second = pair.serve(1)) {
                await(second, READY);
                await(first, "mission 1 of clv: ended at ");
                assertThat(first.out()).contains(PROTECTED);
                assertThat(second.out()).as("what it did meanwhile").doesNotContain(SERVES);

                first.kill();
                pair.cutPower(0);

                await(second, SERVES);
                assertThat(pair.run(0, "pair", "rejoin")).contains("the database that it had is kept in ");
                try (CrwProcess again = pair.serve(0)) {
                    await(again, READY);
                    await(second, PROTECTED);

                    second.kill();
                    pair.cutPower(1);

                    await(again, SERVES);
                }
            }
        }
    }

    @Test
    void aReplicaThatIsPromotedByMistakeHasTheSessionAloneAndTheFirstStopsBefore() throws Exception {
        try (PairedProcesses pair = PairedProcesses.onLoopback(folder);
                CrwProcess first = pair.serve(0);
                CrwProcess second = pair.serve(1)) {
            await(first, PROTECTED);
            await(second, READY);

            pair.promote(1);

            pair.awaitGoesOn(1, second);
            await(second, SERVES);
            assertThat(first.out()).as("the first stopped before").contains("this base stops commanding");
            await(first, pair.address(1) + " took the session over");
            assertThat(first.await(120)).isEqualTo(4);
            assertThat(pair.run(0, "pair", "rejoin")).contains("the database that it had is kept in ");
            try (CrwProcess again = pair.serve(0)) {
                await(again, READY);
                await(second, PROTECTED);
            }
        }
    }

    /** It cannot know then whether the first went on alone meanwhile. */
    @Test
    void aStandbyThatStoodStillWhileItsReplicaWasPromotedGoesOnAtTheWordOfAPerson() throws Exception {
        try (PairedProcesses pair = PairedProcesses.onLoopback(folder);
                CrwProcess first = pair.serve(0);
                CrwProcess second = pair.serve(1)) {
            await(first, PROTECTED);
            await(second, READY);

            second.standStill(true);
            pair.promote(1);
            await(first, pair.address(1) + " took the session over");
            assertThat(first.await(120)).isEqualTo(4);
            Await.holds("longer than a lease", 5, () -> !second.out().contains(SERVES));
            second.standStill(false);

            await(second, "who may go on without this base: if not, 'crw take-over'");
            assertThat(pair.refused(1, 2, "take-over"))
                    .contains("The database of this base no longer follows that of " + pair.address(0))
                    .contains("is lost. To do it: crw take-over --confirm");
            assertThat(pair.run(1, "take-over", "--confirm")).contains("the base that stands by goes on with it");
            await(second, SERVES);
            assertThat(pair.refused(1, 4, "take-over", "--confirm")).contains("nothing is to be taken over here");
        }
    }

    @Test
    void oneOfBothCommandsWhenTheNetworkBetweenThemIsCut() throws Exception {
        cut(networks -> {
            networks.cutFromFirst();
            networks.cutFromSecond();
        });
    }

    @Test
    void oneOfBothCommandsWhenNothingOfTheFirstReachesTheSecond() throws Exception {
        cut(TwoNetworks::cutFromFirst);
    }

    @Test
    void oneOfBothCommandsWhenNothingOfTheSecondReachesTheFirst() throws Exception {
        cut(TwoNetworks::cutFromSecond);
    }

    private void cut(Consumer<TwoNetworks> cutting) throws Exception {
        try (TwoNetworks networks = new TwoNetworks();
                PairedProcesses pair = PairedProcesses.inNetworks(folder, networks);
                CrwProcess first = pair.serve(0);
                CrwProcess second = pair.serve(1)) {
            await(first, SERVES);
            await(first, PROTECTED);
            await(second, READY);

            cutting.accept(networks);

            await(second, SERVES);
            assertThat(first.out()).as("the first stopped before").contains("this base stops commanding");
            networks.heal();
            await(first, "took the session over");
            assertThat(first.await(120)).isEqualTo(4);
            assertThat(second.isAlive()).isTrue();
        }
    }

    @Test
    void aStandbyThatIsEndedLeavesTheFirstAlone() throws Exception {
        try (PairedProcesses pair = PairedProcesses.onLoopback(folder);
                CrwProcess first = pair.serve(0);
                CrwProcess second = pair.serve(1)) {
            await(first, PROTECTED);
            await(second, READY);

            second.terminate();

            await(first, "pair: alone, the standby was ended");
            assertThat(first.isAlive()).isTrue();
            assertThat(pair.run(0, "pair", "status")).contains("database of the session, alone");
        }
    }

    @Test
    void basesThatWereBothSwitchedOffGoOnAlsoWhereTheOneWithTheSessionIsStartedFirst() throws Exception {
        try (PairedProcesses pair = PairedProcesses.onLoopback(folder)) {
            try (CrwProcess first = pair.serve(0);
                    CrwProcess second = pair.serve(1)) {
                await(first, PROTECTED);
                await(second, READY);
                second.kill();
                first.kill();
                pair.cutPower(1);
                pair.cutPower(0);
            }
            try (CrwProcess first = pair.serve(0)) {
                await(first, "may have gone on with the session: this base waits until it answers");

                try (CrwProcess second = pair.serve(1)) {
                    await(first, SERVES);
                    await(first, PROTECTED);
                    await(second, READY);
                }
            }
        }
    }

    @Test
    void aBaseThatWaitsForTheOtherGoesOnAtTheWordOfAPerson() throws Exception {
        try (PairedProcesses pair = PairedProcesses.onLoopback(folder)) {
            try (CrwProcess first = pair.serve(0);
                    CrwProcess second = pair.serve(1)) {
                await(first, PROTECTED);
                second.kill();
                first.kill();
                pair.cutPower(1);
            }
            try (CrwProcess first = pair.serve(0)) {
                await(first, "this base waits until it answers");

                assertThat(pair.run(0, "pair", "alone", "--confirm")).contains("this base goes on without ");

                await(first, SERVES);
            }
        }
    }

    @Test
    void basesThatAreToldTheirOtherAddressesAreAPairAgainWithTheirSession() throws Exception {
        try (TwoNetworks networks = new TwoNetworks();
                PairedProcesses pair = PairedProcesses.inNetworks(folder, networks);
                CrwProcess first = pair.serve(0)) {
            await(first, SERVES);
            networks.giveOtherAddresses();

            assertThat(pair.run(0, "pair", "address", TwoNetworks.SECOND_LATER))
                    .contains("this base is " + TwoNetworks.FIRST_LATER)
                    .contains("does not answer; once it is in this network, there: crw pair address "
                            + TwoNetworks.FIRST_LATER);
            assertThat(pair.run(1, "pair", "address", TwoNetworks.FIRST_LATER))
                    .contains("the bases are connected: nothing more is to be done");

            try (CrwProcess second = pair.serve(1)) {
                await(second, READY);
                await(first, "pair: protected: " + TwoNetworks.SECOND_LATER);
            }
            assertThat(first.isAlive()).isTrue();
        }
    }

    @Test
    void passwordsStandInNoListOfProcessesAndInNoOtherFileOfThePair() throws Exception {
        try (PairedProcesses pair = PairedProcesses.onLoopback(folder);
                CrwProcess first = pair.serve(0);
                CrwProcess second = pair.serve(1)) {
            await(first, PROTECTED);
            await(second, READY);
            List<String> passwords = pair.passwords();
            assertThat(passwords).hasSizeGreaterThan(1).allMatch(password -> password.length() > 20);

            for (String password : passwords) {
                assertThat(ProcessHandle.allProcesses()
                                .map(process -> process.info().commandLine().orElse("")))
                        .noneMatch(line -> line.contains(password));
                assertThat(pair.filesWith(password)).isEmpty();
                assertThat(first.out() + first.err() + second.out() + second.err())
                        .doesNotContain(password);
            }
        }
    }
}
