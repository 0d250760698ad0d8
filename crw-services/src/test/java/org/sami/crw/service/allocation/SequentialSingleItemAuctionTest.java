package org.sami.crw.service.allocation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.event.Allocation;
import org.sami.crw.service.AreaOfTest;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

class SequentialSingleItemAuctionTest {
    private final AllocationAlgorithm auction = new SequentialSingleItemAuction();

    @ParameterizedTest
    @CsvSource({"1,0", "5,0", "1,1", "1,12", "3,2", "3,20", "5,30", "25,7", "10,100"})
    void findsWhatTheSlowAuctionFinds(int boats, int locations) {
        for (long seed = 1; seed <= 40; seed++) {
            AreaOfTest area = new AreaOfTest(seed * 1000 + boats);
            Map<String, GeoPoint> at = area.boats(boats);
            List<GeoPoint> points = area.points(locations);

            Map<String, List<GeoPoint>> found = new LinkedHashMap<>();
            allocate(at, points).paths().forEach((boat, path) -> found.put(boat, path.points()));

            assertThat(found).as("seed %s", seed).isEqualTo(new AuctionByTheThesis(at, points).paths());
        }
    }

    @ParameterizedTest
    @CsvSource({"1,1", "3,20", "5,30", "25,10", "2,60"})
    void putsEachLocationOnExactlyOnePathAndNamesEveryBoat(int boats, int locations) {
        AreaOfTest area = new AreaOfTest(7);
        Map<String, GeoPoint> at = area.boats(boats);
        List<GeoPoint> points = area.points(locations);

        Allocation allocation = allocate(at, points);

        List<GeoPoint> visited = new ArrayList<>();
        allocation.paths().values().forEach(path -> visited.addAll(path.points()));
        assertThat(visited).containsExactlyInAnyOrderElementsOf(points);
        assertThat(allocation.paths().keySet()).containsExactlyElementsOf(at.keySet());
    }

    @Test
    void twoLocationsAtOnePointAreVisitedTwice() {
        GeoPoint point = new AreaOfTest(3).point();
        assertThat(allocate(Map.of("boat-1", AreaOfTest.CENTRE), List.of(point, point, point))
                        .paths())
                .containsEntry("boat-1", new GeoPath(List.of(point, point, point)));
    }

    @Test
    void ofEqualBidsThatOfTheBoatNamedFirstWins() {
        Map<String, GeoPoint> boats = new LinkedHashMap<>();
        boats.put("zeta", AreaOfTest.CENTRE);
        boats.put("alpha", AreaOfTest.CENTRE);
        GeoPoint location = Geodesy.offset(AreaOfTest.CENTRE, 50, 0);

        Allocation allocation = allocate(boats, List.of(location));

        assertThat(allocation.paths().get("zeta").points()).containsExactly(location);
        assertThat(allocation.paths().get("alpha").points()).isEmpty();
    }

    @Test
    void boatsBidTheTimeThatTheyTake() {
        GeoPoint location = Geodesy.offset(AreaOfTest.CENTRE, 100, 0);
        Candidate near = Candidate.at("near", AreaOfTest.CENTRE).atSpeed(0.5);
        Candidate far =
                Candidate.at("far", Geodesy.offset(AreaOfTest.CENTRE, -50, 0)).atSpeed(1.5);

        Division division = auction.divide(
                new AllocationProblem(List.of(near, far), List.of(WorkItem.visit("location 1", location))));

        assertThat(division.boatOf()).containsEntry("location 1", "far");
    }

    @Test
    void eachBoatTakesTheLocationsOnItsSide() {
        Map<String, GeoPoint> boats = new LinkedHashMap<>();
        boats.put("west", Geodesy.offset(AreaOfTest.CENTRE, -200, 0));
        boats.put("east", Geodesy.offset(AreaOfTest.CENTRE, 200, 0));
        GeoPoint west = Geodesy.offset(AreaOfTest.CENTRE, -200, 50);
        GeoPoint east = Geodesy.offset(AreaOfTest.CENTRE, 200, 50);
        GeoPoint furtherEast = Geodesy.offset(AreaOfTest.CENTRE, 200, 80);

        Allocation allocation = allocate(boats, List.of(furtherEast, west, east));

        assertThat(allocation.paths().get("west").points()).containsExactly(west);
        assertThat(allocation.paths().get("east").points()).containsExactly(east, furtherEast);
        assertThat(allocation.totalLengthM()).isCloseTo(130, within(0.01));
        assertThat(allocation.longestM()).isCloseTo(80, within(0.01));
    }

    @Test
    void spreadsTheWorkOverTheBoats() {
        for (long seed = 1; seed <= 20; seed++) {
            AreaOfTest area = new AreaOfTest(seed);
            Allocation allocation = allocate(area.boats(5), area.points(30));

            assertThat(allocation.paths().values())
                    .as("seed %s", seed)
                    .allSatisfy(path -> assertThat(path.points()).isNotEmpty());
            assertThat(allocation.longestM()).isLessThan(allocation.totalLengthM() / 2);
        }
    }

    @Test
    void locationsWithoutABoatAreRefused() {
        List<GeoPoint> locations = new AreaOfTest(1).points(2);

        assertThatThrownBy(() -> AllocationProblem.ofVisits(Map.of(), locations))
                .hasMessageContaining("no boat");
    }

    @Test
    void nothingForNobodyIsAnEmptyAllocation() {
        Allocation allocation = allocate(Map.of(), List.of());

        assertThat(allocation.paths()).isEmpty();
        assertThat(allocation.totalLengthM()).isZero();
    }

    @Test
    void tenThousandLocationsAreAllocated() {
        AreaOfTest area = new AreaOfTest(11);
        Map<String, GeoPoint> boats = area.boats(25);

        long visited = allocate(boats, area.points(10_000)).paths().values().stream()
                .mapToLong(path -> path.points().size())
                .sum();

        assertThat(visited).isEqualTo(10_000);
    }

    private Allocation allocate(Map<String, GeoPoint> boats, List<GeoPoint> locations) {
        return auction.divide(AllocationProblem.ofVisits(boats, locations)).toAllocation("");
    }
}
