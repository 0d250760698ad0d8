package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.sami.boat.link.KeptFile;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.command.Panorama;
import org.sami.crw.proxy.file.BoatFileFetch;
import org.sami.crw.proxy.file.FileNews;
import org.sami.crw.sim.boat.TcpTestFleet.Base;
import org.sami.spn.protocol.Priority;

/** A boat that is told to take a panorama keeps its pictures, and a base fetches them. */
@Tag("long")
@Execution(ExecutionMode.CONCURRENT)
@Timeout(900)
class PicturesOverTcpTest {
    @TempDir
    private Path folder;

    /** How boat and base are linked. */
    TestLinks links() {
        return TestLinks.plain();
    }

    @Test
    void picturesOfAPanoramaAreOnBoardWhenItIsCompletedAndCanBeFetched() throws Exception {
        Path onBoard = folder.resolve("boats");
        try (TcpTestFleet fleet = new TcpTestFleet(onBoard, links())) {
            BoatOnTcp boat = fleet.boat("anna");
            Base base = fleet.base("base");
            base.connect(boat.address(), "anna");
            base.submit("anna", new Panorama("p1", 1, 1, 8, Priority.MEDIUM));
            Await.until("the panorama is completed", () -> base.count("anna completed p1") == 1);

            BoatFileFetch fetch =
                    new BoatFileFetch(boat.address(), fleet.kindOfLinks().ofBaseItself(), FileNews.NONE);
            BoatFileFetch.Result result = fetch.fetchAll(KeptFile.PICTURE, folder.resolve("base"));

            List<String> names = result.files().stream()
                    .map(file -> file.getFileName().toString())
                    .toList();
            assertThat(names).hasSize(8).first().isEqualTo("anna-000001.jpg");
            assertThat(result.refused()).isEmpty();
            for (Path file : result.files()) {
                assertThat(file)
                        .hasSameBinaryContentAs(onBoard.resolve("anna-pictures").resolve(file.getFileName()));
                BufferedImage image = ImageIO.read(Files.newInputStream(file));
                assertThat(image.getWidth()).isEqualTo(640);
            }
        }
    }
}
