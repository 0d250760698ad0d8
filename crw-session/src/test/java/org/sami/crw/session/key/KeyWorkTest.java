package org.sami.crw.session.key;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.key.FleetKey;

/** What a window does with the key with which vehicles of other makers sign, in real folders. */
@Timeout(300)
class KeyWorkTest {
    private static final String PASSWORD = "in the boat house";

    @TempDir
    private Path folder;

    private final BlockingQueue<Runnable> front = new LinkedBlockingQueue<>();
    private KeyWork work;

    @BeforeEach
    void readsTheKeysOfALaptop() throws Exception {
        work = of("one");
        work.read();
        end(work);
    }

    private KeyWork of(String laptop) {
        return new KeyWork(new BaseKeys(folder.resolve(laptop)), front::add, () -> {}, () -> {});
    }

    /** Runs on this thread, as the front, what the work tells. */
    private void end(KeyWork running) throws Exception {
        while (running.isBusy()) {
            front.take().run();
        }
    }

    private Optional<FleetKey> key(KeyWork of) {
        return of.listing().orElseThrow().fleet();
    }

    private String print() {
        return key(work).orElseThrow().fingerprint();
    }

    private void make() throws Exception {
        work.makeFleetKey();
        end(work);
    }

    @Test
    void vehicleKeyIsMadeOnceAndShownByItsFingerprintAlone() throws Exception {
        assertThat(key(work)).isEmpty();

        make();
        String made = print();
        assertThat(made).matches("[0-9a-f]{16}");
        assertThat(work.said()).startsWith("The key is made");
        make();

        assertThat(print()).isEqualTo(made);
        assertThat(work.said()).isEqualTo("The fleet has a key already; vehicles sign with the key " + made);
    }

    @Test
    void vehicleKeyThatIsReplacedIsAnotherOneAndWhatThatMeansIsSaid() throws Exception {
        make();
        String former = print();

        work.renewFleetKey();
        end(work);

        assertThat(print()).isNotEqualTo(former);
        assertThat(work.said()).contains("Vehicles obey the one before it until each is given the new one");
    }

    @Test
    void vehicleKeyGoesToASecondLaptopWithTheOthers() throws Exception {
        make();
        Path file = folder.resolve("fleet.keys");
        work.exportTo(file, PASSWORD.toCharArray(), PASSWORD.toCharArray());
        end(work);
        assertThat(work.said()).endsWith("and 0 boats; vehicles sign with the key " + print());

        KeyWork second = of("two");
        second.importFrom(file, PASSWORD.toCharArray());
        end(second);

        assertThat(key(second).orElseThrow().fingerprint()).isEqualTo(print());
        assertThat(second.said()).endsWith("; vehicles sign with the key " + print());
    }
}
