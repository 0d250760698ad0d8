package org.sami.ui.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.palette.IdentityMark;
import org.sami.picture.net.NetMarking;
import org.sami.picture.net.NetMode;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Token;

class NetViewTest {
    private final Plan plan = NetScenes.plan("clv");
    private final NetView view = NetScenes.view(plan, 1200, 800);

    @Test
    void showsAllThatTheModeShowsAtFirst() {
        assertThat(view.scene().vertices()).isNotEmpty().allSatisfy(vertex -> {
            Point2D at = view.pixel(vertex.centre().x(), vertex.centre().y());
            assertThat(at.getX()).isBetween(0.0, 1200.0);
            assertThat(at.getY()).isBetween(0.0, 800.0);
        });
    }

    @Test
    void showsAPlanAsSoonAsItHasASize() {
        NetView late = new NetView(new org.sami.palette.ProxyMarks());
        late.show(plan, NetScenes.VOCABULARY);
        late.setSize(1200, 800);
        late.doLayout();

        assertThat(late.zoom()).isEqualTo(view.zoom());
    }

    @Test
    void fitsWhatTheModeShowsAndNotWhatItHides() {
        NetView nominal = NetScenes.view(NetScenes.plan("explore-team"), 900, 300);
        double whole = nominal.zoom();

        nominal.setMode(NetMode.ALL);
        nominal.fit();

        assertThat(nominal.zoom()).isLessThan(whole * 0.8);
    }

    @Test
    void aViewThatFollowsIsReadAndKeepsMovedTokensInSight() {
        NetView small = NetScenes.view(plan, 400, 200);
        assertThat(small.zoom()).isLessThan(0.5);
        small.setFollowing(true);
        assertThat(small.zoom()).isGreaterThanOrEqualTo(0.8);

        for (Vertex place : small.scene().vertices()) {
            if (plan.place(place.id()).isPresent()) {
                small.setMarking(new NetMarking(Map.of(place.id(), List.of(Token.GENERIC)), Set.of(), Map.of()));
                Point2D at = small.pixel(place.centre().x(), place.centre().y());
                assertThat(at.getX()).isBetween(0.0, 400.0);
                assertThat(at.getY()).isBetween(0.0, 200.0);
            }
        }
    }

    @Test
    void whatBecomesActiveIsShownWithTheNetAroundIt() {
        NetView small = following();
        double room = 0.2 * 165;
        Rectangle2D net = new Rectangle2D.Double();
        for (Vertex place : small.scene().vertices()) {
            if (plan.place(place.id()).isPresent()) {
                stand(small, place);

                Rectangle2D around = pixels(small, place.box());
                around.setFrame(
                        around.getX() - room,
                        around.getY() - room,
                        around.getWidth() + 2 * room,
                        around.getHeight() + 2 * room);
                net.setRect(pixels(small, small.scene().shownBounds()));
                assertThat(new Rectangle2D.Double(0, 0, 585, 165).contains(around.createIntersection(net)))
                        .as(place.id())
                        .isTrue();
            }
        }
    }

    @Test
    void aPlaceAtTheNetsEdgeIsShownWithoutMoreBesideTheNetThanItsMargin() {
        NetView small = following();
        stand(small, vertex(plan.places().get(plan.places().size() - 1).id()));
        stand(small, vertex(plan.places().get(0).id()));

        assertThat(pixels(small, small.scene().shownBounds()).getMinX()).isBetween(0.0, 25.0);
    }

    @Test
    void aViewThatWasMovedByHandFollowsAgainWhenAllIsShown() {
        NetView small = following();
        List<Vertex> places = small.scene().vertices().stream()
                .filter(vertex -> plan.place(vertex.id()).isPresent())
                .toList();
        Vertex first = places.get(0);
        Vertex last = places.get(places.size() - 1);
        stand(small, first);
        small.press(NetKey.LEFT);
        LayoutPoint byHand = small.centre();

        stand(small, last);
        assertThat(small.centre()).isEqualTo(byHand);

        small.press(NetKey.FIT);
        small.press(NetKey.ACTUAL_SIZE);
        stand(small, first);
        assertThat(seen(small, first)).isFalse(); // zooming is by hand as well

        small.press(NetKey.FIT);
        small.setSize(100, 60);
        small.doLayout();
        stand(small, last);
        assertThat(seen(small, last)).isTrue();
    }

    @Test
    void whatIsFollowedStaysInSightWhenTheViewBecomesSmaller() {
        NetView small = following();
        Vertex place = vertex(plan.places().get(plan.places().size() - 1).id());
        stand(small, place);

        small.setSize(120, 100);
        small.doLayout();

        assertThat(seen(small, place)).isTrue();
    }

    private NetView following() {
        NetView small = NetScenes.view(plan, 585, 165);
        small.setFollowing(true);
        return small;
    }

    private static void stand(NetView net, Vertex place) {
        net.setMarking(new NetMarking(Map.of(place.id(), List.of(Token.GENERIC)), Set.of(), Map.of()));
    }

    private static Rectangle2D pixels(NetView net, DrawingBox box) {
        Rectangle2D pixels = new Rectangle2D.Double();
        pixels.setFrameFromDiagonal(net.pixel(box.x(), box.y()), net.pixel(box.maxX(), box.maxY()));
        return pixels;
    }

    private static boolean seen(NetView net, Vertex place) {
        return net.canvas().getBounds().contains(pixels(net, place.box()));
    }

    @Test
    void aProxyTokenHasItsProxysColour() {
        Vertex place = vertex(plan.places().get(1).id());
        zoomIn();

        view.setMarking(new NetMarking(Map.of(place.id(), List.of(new Token.Proxy("anna"))), Set.of(), Map.of()));

        assertThat(new Color(NetScenes.paint(view).getRGB(x(place), y(place)))).isEqualTo(new IdentityMark(0).color());
    }

    @Test
    void moreThanFiveTokensAreANumber() {
        Vertex place = vertex(plan.places().get(1).id());
        List<Token> six = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            six.add(new Token.Proxy("proxy-" + i));
        }
        zoomIn();

        view.setMarking(new NetMarking(Map.of(place.id(), six.subList(0, 5)), Set.of(), Map.of()));
        assertThat(coloursAround(place)).contains(new IdentityMark(2).color());
        view.setMarking(new NetMarking(Map.of(place.id(), six), Set.of(), Map.of()));
        assertThat(coloursAround(place)).doesNotContain(new IdentityMark(2).color());
    }

    @Test
    void aFiringTransitionShinesUnlessThatIsTurnedOff() {
        Vertex transition = vertex(plan.transitions().get(0).id());
        Color still = colour(transition);

        view.fired(transition.id());
        assertThat(colour(transition)).isNotEqualTo(still);

        view.setPulse(false);
        view.fired(transition.id());
        assertThat(colour(transition)).isEqualTo(still);
    }

    @Test
    void thePulseEndsAfterAQuarterOfASecond() {
        long[] now = {0};
        NetPulse pulse = new NetPulse(() -> now[0], () -> {});
        pulse.fired("t");
        assertThat(pulse.of("t")).isEqualTo(1);
        now[0] = 125_000_000;
        assertThat(pulse.of("t")).isEqualTo(0.5);
        now[0] = 250_000_000;
        assertThat(pulse.of("t")).isZero();
        pulse.setOn(false);
    }

    @Test
    void clicksSelectAndOpen() {
        List<String> heard = new ArrayList<>();
        view.addNetListener(new NetListener() {
            @Override
            public void selected(Set<String> ids) {
                heard.add("selected " + ids.size());
            }

            @Override
            public void opened(String id) {
                heard.add("opened " + id);
            }
        });
        Vertex first = vertex(plan.places().get(0).id());
        Vertex second = vertex(plan.places().get(1).id());

        click(first, 0, 1);
        click(second, InputEvent.CTRL_DOWN_MASK, 1);
        assertThat(view.selected()).containsExactlyInAnyOrder(first.id(), second.id());
        click(first, 0, 1);
        click(first, 0, 2);

        assertThat(heard).contains("selected 2", "opened " + first.id());
    }

    @Test
    void aBoxSelectsWhatIsInIt() {
        mouse(MouseEvent.MOUSE_PRESSED, 1, 1, InputEvent.SHIFT_DOWN_MASK, 1);
        mouse(MouseEvent.MOUSE_DRAGGED, 1198, 798, InputEvent.SHIFT_DOWN_MASK, 0);
        mouse(MouseEvent.MOUSE_RELEASED, 1198, 798, InputEvent.SHIFT_DOWN_MASK, 1);

        assertThat(view.selected()).hasSize(view.scene().vertices().size());
    }

    @Test
    void keysGoFromVertexToVertex() {
        view.press(NetKey.NEXT);
        assertThat(view.selected())
                .containsExactly(view.scene().vertices().get(0).id());
        view.press(NetKey.NEXT);
        assertThat(view.selected())
                .containsExactly(view.scene().vertices().get(1).id());
        view.press(NetKey.PREVIOUS);
        view.press(NetKey.PREVIOUS);
        assertThat(view.selected())
                .containsExactly(view.scene()
                        .vertices()
                        .get(view.scene().vertices().size() - 1)
                        .id());
        view.press(NetKey.CLEAR);
        assertThat(view.selected()).isEmpty();
    }

    @Test
    void keysGoThroughAllVerticesInRecoveryModeToo() {
        view.setMode(NetMode.RECOVERY);
        Set<String> seen = new HashSet<>();
        for (int i = 0; i < view.drawing().vertices().size(); i++) {
            view.press(NetKey.NEXT);
            seen.addAll(view.selected());
        }

        assertThat(seen).hasSameSizeAs(view.drawing().vertices());
    }

    @Test
    void theWheelZoomsAroundThePointer() {
        Vertex vertex = vertex(plan.places().get(2).id());
        Point2D before = view.pixel(vertex.centre().x(), vertex.centre().y());
        double zoom = view.zoom();

        view.canvas()
                .dispatchEvent(new MouseWheelEvent(
                        view.canvas(),
                        MouseEvent.MOUSE_WHEEL,
                        0,
                        0,
                        (int) before.getX(),
                        (int) before.getY(),
                        0,
                        false,
                        0,
                        1,
                        -1));

        assertThat(view.zoom()).isGreaterThan(zoom * 1.1);
        assertThat(view.pixel(vertex.centre().x(), vertex.centre().y()).distance(before))
                .isLessThan(2);
    }

    @Test
    void aTooltipNamesTokensAndSaysWhyNot() {
        Vertex place = vertex(plan.places().get(1).id());
        Vertex transition = vertex(plan.transitions().get(1).id());
        view.setMarking(new NetMarking(Map.of(place.id(), List.of(new Token.Proxy("anna"))), Set.of(), Map.of()));
        view.setExplanation(id -> id.equals(transition.id()) ? Optional.of("waits for anna & bert") : Optional.empty());

        assertThat(tip(place)).contains("1 token: anna");
        assertThat(tip(transition)).contains("waits for anna & bert");
    }

    @Test
    void aNetThatIsTooSmallForItsWordsHasNames() {
        NetView small = NetScenes.view(plan, 500, 320);
        assertThat(small.zoom()).isLessThan(0.4);
        long withNames = dark(NetScenes.paint(small));

        Plan nameless = plan.withId("nameless")
                .withPlaces(plan.places().stream()
                        .map(place -> place.withName("").withOutputs(List.of()).withSubMissions(List.of()))
                        .toList())
                .withTransitions(plan.transitions().stream()
                        .map(transition -> transition.withName("").withInputs(List.of()))
                        .toList());
        small.show(nameless, NetScenes.VOCABULARY);

        assertThat(dark(NetScenes.paint(small))).isLessThan(withNames - 200);
    }

    @Test
    void aNameOnASmallNetIsNotCutAtItsEdge() {
        NetView small = NetScenes.view(plan, 500, 320);
        BufferedImage image = NetScenes.paint(small);
        BufferedImage rims = new BufferedImage(4, image.getHeight(), BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < image.getHeight(); y++) {
            rims.setRGB(0, y, image.getRGB(0, y));
            rims.setRGB(1, y, image.getRGB(1, y));
            rims.setRGB(2, y, image.getRGB(image.getWidth() - 2, y));
            rims.setRGB(3, y, image.getRGB(image.getWidth() - 1, y));
        }

        assertThat(dark(rims)).isZero();
    }

    private static long dark(BufferedImage image) {
        return Arrays.stream(image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()))
                .filter(rgb -> (rgb & 0xFF) < 0x60)
                .count();
    }

    @Test
    void thePlansOwnLayoutIsLeftAlone() {
        Map<String, ?> before = Map.copyOf(plan.layout());

        view.showLayered(plan, NetScenes.VOCABULARY);

        assertThat(plan.layout()).isEqualTo(before);
        view.show(plan, NetScenes.VOCABULARY);
        assertThat(view.drawing().vertices()).allSatisfy(vertex -> {
            assertThat(vertex.centre().x())
                    .isEqualTo(
                            plan.layout().get(vertex.id()).x() * view.drawing().scale());
            assertThat(vertex.centre().y())
                    .isEqualTo(
                            plan.layout().get(vertex.id()).y() * view.drawing().scale());
        });
    }

    private void zoomIn() {
        view.press(NetKey.ACTUAL_SIZE);
        Vertex place = vertex(plan.places().get(1).id());
        view.select(Set.of());
        view.highlight(Set.of(place.id()));
        view.highlight(Set.of());
    }

    private Vertex vertex(String id) {
        return view.drawing().vertices().stream()
                .filter(vertex -> vertex.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    private int x(Vertex vertex) {
        return (int)
                Math.round(view.pixel(vertex.centre().x(), vertex.centre().y()).getX());
    }

    private int y(Vertex vertex) {
        return (int)
                Math.round(view.pixel(vertex.centre().x(), vertex.centre().y()).getY());
    }

    private Color colour(Vertex vertex) {
        return new Color(NetScenes.paint(view).getRGB(x(vertex), y(vertex)));
    }

    private Set<Color> coloursAround(Vertex place) {
        BufferedImage image = NetScenes.paint(view);
        Set<Color> colours = new HashSet<>();
        for (int dx = -15; dx <= 15; dx++) {
            for (int dy = -15; dy <= 15; dy++) {
                colours.add(new Color(image.getRGB(x(place) + dx, y(place) + dy)));
            }
        }
        return colours;
    }

    private String tip(Vertex vertex) {
        return view.canvas()
                .getToolTipText(
                        new MouseEvent(view.canvas(), MouseEvent.MOUSE_MOVED, 0, 0, x(vertex), y(vertex), 0, false));
    }

    private void click(Vertex vertex, int modifiers, int count) {
        mouse(MouseEvent.MOUSE_PRESSED, x(vertex), y(vertex), modifiers, count);
        mouse(MouseEvent.MOUSE_RELEASED, x(vertex), y(vertex), modifiers, count);
    }

    private void mouse(int id, int x, int y, int modifiers, int count) {
        view.canvas()
                .dispatchEvent(new MouseEvent(
                        view.canvas(),
                        id,
                        0,
                        modifiers | MouseEvent.BUTTON1_DOWN_MASK,
                        x,
                        y,
                        count,
                        false,
                        MouseEvent.BUTTON1));
    }
}
