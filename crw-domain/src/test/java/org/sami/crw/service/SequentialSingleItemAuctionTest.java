package org.sami.crw.service;

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
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;

class SequentialSingleItemAuctionTest {
    private final AllocationAlgorithm auction = new SequentialSingleItemAuction();

    @ParameterizedTest
    @CsvSource({"1,0", "5,0", "1,1", "1,12", "3,2", "3,20", "5,30", "25,7", "10,100"})
    void findsWhatTheSlowAuctionFinds(int boats, int locations) {
        for (long seed = 1; seed <= 40; seed++) {
            AreaOfTest area = new AreaOfTest(seed * 1000 + boats);
            AllocationProblem problem = new AllocationProblem(area.boats(boats), area.points(locations));

            Map<String, List<GeoPoint>> found = new LinkedHashMap<>();
            auction.allocate(problem).paths().forEach((boat, path) -> found.put(boat, path.points()));

            assertThat(found).as("seed %s", seed).isEqualTo(new SlowAuction(problem).paths());
        }
    }

    @ParameterizedTest
    @CsvSource({"1,1", "3,20", "5,30", "25,10", "2,60"})
    void putsEachLocationOnExactlyOnePathAndNamesEveryBoat(int boats, int locations) {
        AreaOfTest area = new AreaOfTest(7);
        AllocationProblem problem = new AllocationProblem(area.boats(boats), area.points(locations));

        Allocation allocation = auction.allocate(problem);

        List<GeoPoint> visited = new ArrayList<>();
        allocation.paths().values().forEach(path -> visited.addAll(path.points()));
        assertThat(visited).containsExactlyInAnyOrderElementsOf(problem.locations());
        assertThat(allocation.paths().keySet())
                .containsExactlyElementsOf(problem.boats().keySet());
    }

    @Test
    void twoLocationsAtOnePointAreVisitedTwice() {
        GeoPoint point = new AreaOfTest(3).point();
        AllocationProblem problem =
                new AllocationProblem(Map.of("boat-1", AreaOfTest.CENTRE), List.of(point, point, point));

        assertThat(auction.allocate(problem).paths())
                .containsEntry("boat-1", new GeoPath(List.of(point, point, point)));
    }

    @Test
    void ofEqualBidsThatOfTheBoatNamedFirstWins() {
        Map<String, GeoPoint> boats = new LinkedHashMap<>();
        boats.put("zeta", AreaOfTest.CENTRE);
        boats.put("alpha", AreaOfTest.CENTRE);
        GeoPoint location = Geodesy.offset(AreaOfTest.CENTRE, 50, 0);

        Allocation allocation = auction.allocate(new AllocationProblem(boats, List.of(location)));

        assertThat(allocation.paths().get("zeta").points()).containsExactly(location);
        assertThat(allocation.paths().get("alpha").points()).isEmpty();
    }

    @Test
    void eachBoatTakesTheLocationsOnItsSide() {
        Map<String, GeoPoint> boats = new LinkedHashMap<>();
        boats.put("west", Geodesy.offset(AreaOfTest.CENTRE, -200, 0));
        boats.put("east", Geodesy.offset(AreaOfTest.CENTRE, 200, 0));
        GeoPoint west = Geodesy.offset(AreaOfTest.CENTRE, -200, 50);
        GeoPoint east = Geodesy.offset(AreaOfTest.CENTRE, 200, 50);
        GeoPoint furtherEast = Geodesy.offset(AreaOfTest.CENTRE, 200, 80);

        Allocation allocation = auction.allocate(new AllocationProblem(boats, List.of(furtherEast, west, east)));

        assertThat(allocation.paths().get("west").points()).containsExactly(west);
        assertThat(allocation.paths().get("east").points()).containsExactly(east, furtherEast);
        assertThat(allocation.totalLengthM()).isCloseTo(130, within(0.01));
        assertThat(allocation.longestM()).isCloseTo(80, within(0.01));
    }

    @Test
    void spreadsTheWorkOverTheBoats() {
        for (long seed = 1; seed <= 20; seed++) {
            AreaOfTest area = new AreaOfTest(seed);
            AllocationProblem problem = new AllocationProblem(area.boats(5), area.points(30));

            Allocation allocation = auction.allocate(problem);

            assertThat(allocation.paths().values())
                    .as("seed %s", seed)
                    .allSatisfy(path -> assertThat(path.points()).isNotEmpty());
            assertThat(allocation.longestM()).isLessThan(allocation.totalLengthM() / 2);
        }
    }

    @Test
    void locationsWithoutABoatAreRefused() {
        List<GeoPoint> locations = new AreaOfTest(1).points(2);

        assertThatThrownBy(() -> new AllocationProblem(Map.of(), locations)).hasMessageContaining("no boat");
    }

    @Test
    void nothingForNobodyIsAnEmptyAllocation() {
        Allocation allocation = auction.allocate(new AllocationProblem(Map.of(), List.of()));

        assertThat(allocation.paths()).isEmpty();
        assertThat(allocation.totalLengthM()).isZero();
    }

    @Test
    void tenThousandLocationsAreAllocated() {
        AreaOfTest area = new AreaOfTest(11);
        AllocationProblem problem = new AllocationProblem(area.boats(25), area.points(10_000));

        long visited = auction.allocate(problem).paths().values().stream()
                .mapToLong(path -> path.points().size())
                .sum();

        assertThat(visited).isEqualTo(10_000);
    }
}
