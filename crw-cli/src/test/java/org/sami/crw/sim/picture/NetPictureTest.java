package org.sami.crw.sim.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.cli.CommandResult;
import org.sami.picture.net.NetPicture;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.legacy.LegacyTableReader;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;
import org.w3c.dom.Document;
import org.xml.sax.InputSource;

class NetPictureTest {
    private static final String CRW = "/org/sami/domain/crw";
    private static final DomainLibrary LIBRARY =
            DomainLibrary.fromClassPath(CRW).orThrow();
    private static final Vocabulary VOCABULARY = LIBRARY.vocabulary();

    @TempDir
    Path folder;

    @Test
    void noLabelOfAShippedPlanCoversAVertexOrAnotherLabel() {
        LIBRARY.plans().forEach(NetPictureTest::assertNothingIsCovered);
    }

    @ParameterizedTest
    @ValueSource(strings = {"thesis", "crw"})
    void noLabelOfAFieldPlanCoversAVertexOrAnotherLabel(String name) {
        Path file = Path.of("../../shared/legacy-plans", name + ".json");
        assumeTrue(Files.exists(file), "skipped: " + file + " is not here");
        LegacyImport.Result imported = new LegacyImport(
                        VOCABULARY,
                        LegacyTableReader.fromClassPath(CRW + "/legacy.json", VOCABULARY)
                                .orThrow())
                .read(file);

        imported.project().orElseThrow().plans().forEach(NetPictureTest::assertNothingIsCovered);
    }

    private static void assertNothingIsCovered(Plan plan) {
        for (boolean anew : new boolean[] {false, true}) {
            NetDrawing drawing = NetPicture.of(plan, VOCABULARY, anew).drawing();
            List<DrawingBox> boxes = new ArrayList<>();
            drawing.vertices().forEach(vertex -> boxes.add(vertex.box()));
            drawing.labels().forEach(label -> boxes.add(label.box()));
            for (int i = 0; i < boxes.size(); i++) {
                for (int j = i + 1; j < boxes.size(); j++) {
                    assertThat(boxes.get(i).intersects(boxes.get(j)))
                            .as("%s, anew %s: %s and %s", plan.id(), anew, boxes.get(i), boxes.get(j))
                            .isFalse();
                }
            }
            assertThat(drawing.vertices())
                    .hasSize(plan.places().size() + plan.transitions().size());
            assertThat(drawing.edges())
                    .hasSize(plan.inEdges().size() + plan.outEdges().size());
        }
    }

    @Test
    void layersLeadFromTheStartToTheEnd() {
        NetDrawing drawing = NetPicture.of(plan("clv"), VOCABULARY, true).drawing();

        double least = drawing.vertices().stream()
                .mapToDouble(v -> v.centre().x())
                .min()
                .orElseThrow();
        double most = drawing.vertices().stream()
                .mapToDouble(v -> v.centre().x())
                .max()
                .orElseThrow();
        assertThat(drawing.vertices())
                .filteredOn(NetDrawing.Vertex::start)
                .allMatch(start -> start.kind() == Kind.PLACE && start.centre().x() < least + 100);
        assertThat(drawing.vertices())
                .filteredOn(NetDrawing.Vertex::end)
                .allMatch(end -> end.centre().x() > most - 100);
    }

    @Test
    void layoutOfTheFileIsKept() {
        NetDrawing drawing = NetPicture.of(plan("clv"), VOCABULARY, false).drawing();

        assertThat(centre(drawing, "select").y())
                .isEqualTo(centre(drawing, "finished").y());
        assertThat(centre(drawing, "end").x())
                .isEqualTo(centre(drawing, "finished").x());
        assertThat(centre(drawing, "rejected").y())
                .isLessThan(centre(drawing, "select").y());
    }

    @Test
    void commandWritesBothPicturesAndSaysWhatItReplaced() throws Exception {
        Path svg = folder.resolve("new/clv.svg");
        Path png = folder.resolve("clv.png");

        CommandResult first = CommandResult.crw("draw", "clv", "--svg", svg.toString(), "--png", png.toString());
        CommandResult second = CommandResult.crw("draw", "clv", "--svg", svg.toString(), "--layout");
        CommandResult nowhere = CommandResult.crw("draw", "clv");

        assertThat(first).isEqualTo(new CommandResult(0, "written to " + svg + "\nwritten to " + png + "\n", ""));
        assertThat(second.out()).isEqualTo("replaced " + svg + "\n");
        assertThat(nowhere.exitCode()).isEqualTo(2);
        assertThat(ImageIO.read(new ByteArrayInputStream(Files.readAllBytes(png)))
                        .getWidth())
                .isGreaterThan(1000);
        Document document = DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new InputSource(new StringReader(Files.readString(svg))));
        long rings = plan("clv").places().stream()
                .mapToInt(place -> place.subMissions().isEmpty() ? 1 : 2)
                .sum();
        assertThat(document.getElementsByTagName("circle").getLength()).isEqualTo((int) rings);
        assertThat(document.getElementsByTagName("text").item(0).getTextContent())
                .isEqualTo("Cooperative Location Visit");
        assertThat(document.getDocumentElement().getTextContent())
                .contains("Take All Relevant", "→ Proxy Execute Path", "No Proxy");
    }

    /** Control characters, halves of a pair, markup: XML allows none of them as they are. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "bell \u0007 and escape \u001b[31m",
                "null \u0000",
                "half of a pair \ud83d",
                "no character \uffff",
                "<script>alert('&')</script> ]]> <!-- \"",
                "a boat \ud83d\udea4"
            })
    void namesOfAnyKindLeaveAPictureThatIsXml(String name) throws Exception {
        Plan plan = plan("clv");
        Plan named = plan.withName(name)
                .withPlaces(plan.places().stream()
                        .map(place -> place.withName(place.name() + name))
                        .toList());

        String svg = NetPicture.of(named, VOCABULARY, true).svg();

        Document document =
                DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(new InputSource(new StringReader(svg)));
        assertThat(document.getElementsByTagName("script").getLength()).isZero();
        assertThat(document.getElementsByTagName("title").item(0).getTextContent())
                .startsWith(name.substring(0, 4));
    }

    private static Plan plan(String id) {
        return LIBRARY.projectOf(id).orElseThrow().plan(id).orElseThrow();
    }

    private static org.sami.spn.model.LayoutPoint centre(NetDrawing drawing, String id) {
        return drawing.vertices().stream()
                .filter(vertex -> vertex.id().equals(id))
                .findFirst()
                .orElseThrow()
                .centre();
    }
}
